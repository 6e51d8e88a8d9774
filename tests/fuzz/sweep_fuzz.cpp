// Any text as the sweep and the variants of an otherwise valid case.
#include "tests/fuzz/fuzz_input.hpp"

#include "cases/catalog/case.hpp"

#include <string>

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string text = R"(name = "x"
title = "x"
source = "x"
text = "x"
suites = ["full"]
time_limit = 1.0
[scene]
gravity = 0.0
periodic_x = 12.0
periodic_y = 12.0
integrator = "verlet-half-step"
dt = 1e-3
contact_times = 5.0
frames = { every_contact_times = 0.1 }
grains = { diameter = 2.0, mass = 1.0 }
initial = { kind = "gas", count = 4, velocity_spread = 3.0 }
[scene.contact]
restitution = 0.8
contact_time = 0.1
damping = "full-vector"
clipping = "none"
spins = "off"
[[observable]]
name = "momentum"
[sweep]
)";
    text += tests::text_of(data, size);
    const tests::MemoryFile file(text);
    return tests::refuses_or_reads(
        [&] { (void)catalog::load_case(file.path(), catalog::Suite::full); });
}
