// Any bytes as a rule table of the lattice gas.
#include "tests/fuzz/fuzz_input.hpp"

#include "cases/scene/gas_reading_file.hpp"

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const tests::MemoryFile file(tests::text_of(data, size));
    return tests::refuses_or_reads([&] { (void)scene::load_gas_reading(file.path()); });
}
