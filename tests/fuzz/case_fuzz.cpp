// Any bytes as a case file, in every suite.
#include "tests/fuzz/fuzz_input.hpp"

#include "cases/catalog/case.hpp"

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const tests::MemoryFile file(tests::text_of(data, size));
    return tests::refuses_or_reads([&] {
        (void)catalog::load_case(file.path(), catalog::Suite::full,
                                 CROSSGRAIN_SOURCE_DIR "/cases/catalog/readings");
    });
}
