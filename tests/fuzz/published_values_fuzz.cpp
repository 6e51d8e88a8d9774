// Any bytes as a file of published values.
#include "tests/fuzz/fuzz_input.hpp"

#include "reference/published/published.hpp"
#include "tests/support/temporary_directory.hpp"

#include <fstream>

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const tests::TemporaryDirectory directory;
    std::ofstream(directory.path() / "paper.toml", std::ios::binary) << tests::text_of(data, size);
    return tests::refuses_or_reads([] { (void)published::PublishedValues(directory.path()); });
}
