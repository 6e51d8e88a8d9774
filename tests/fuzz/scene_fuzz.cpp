// Any text as the scene of an otherwise valid case. The first byte chooses the model.
#include "tests/fuzz/fuzz_input.hpp"

#include "cases/catalog/case.hpp"

#include <array>
#include <string>

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr std::array models{"grains", "lattice-gas", "hopper-automaton", "synthetic-signal"};
    std::string text = "name = 'x'\ntitle = 'x'\nsource = 'x'\ntext = 'x'\nsuites = ['full']\n"
                       "time_limit = 1.0\nmodel = '";
    text += models[data[0] % models.size()];
    text += "'\n[[observable]]\nname = 'x'\n[scene]\n";
    text += tests::text_of(data + 1, size - 1);
    const tests::MemoryFile file(text);
    return tests::refuses_or_reads([&] {
        (void)catalog::load_case(file.path(), catalog::Suite::full,
                                 CROSSGRAIN_SOURCE_DIR "/cases/catalog/readings");
    });
}
