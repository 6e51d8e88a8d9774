// Any bytes as the prepared state of two grains.
#include "tests/fuzz/fuzz_input.hpp"

#include "cases/scene/prepared_state.hpp"

#include <cstdlib>

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t grains = 2;
    try {
        const auto state = scene::state_from(tests::text_of(data, size), grains);
        if (state.x.size() != grains || state.y.size() != grains) std::abort();
    } catch (const std::invalid_argument&) {
    }
    return 0;
}
