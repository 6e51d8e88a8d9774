// Any bytes as the dump of two discs, in pieces whose length the first byte says.
#include "tests/fuzz/fuzz_input.hpp"

#include "adapters/dump/dump_reader.hpp"
#include "cases/scene/frame_guard.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static const scene::Scene scene = [] {
        auto two = tests::empty_scene("two", 1e-3, 0.01);
        two.grains = {.diameter = 2.0, .mass = 1.0};
        two.initial.x = {0, 3};
        two.initial.y = {0, 0};
        two.initial.vx = two.initial.vy = {0, 0};
        return two;
    }();
    const std::size_t piece = 1 + data[0];
    auto rest = tests::text_of(data + 1, size - 1);
    return tests::refuses_or_reads([&] {
        scene::FrameGuard guard(scene, [](const scene::Frame&) {});
        adapters::dump::DumpReader reader(scene, std::ref(guard));
        while (!rest.empty()) {
            reader.feed(rest.substr(0, piece));
            rest.remove_prefix(std::min(piece, rest.size()));
        }
        reader.finish();
        guard.finish();
    });
}
