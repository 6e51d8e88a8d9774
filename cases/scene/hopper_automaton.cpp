#include "cases/scene/hopper_automaton.hpp"

namespace crossgrain::scene {

std::string to_string(HopperSweep value) {
    return value == HopperSweep::bottom_to_top ? "bottom-to-top" : "top-to-bottom";
}

std::string to_string(HopperRows value) {
    return value == HopperRows::half_levels ? "half-levels" : "zigzag";
}

std::string to_string(HopperInertia value) {
    return value == HopperInertia::source_orientation ? "source-orientation" : "literal";
}

std::string to_string(HopperRandom value) {
    return value == HopperRandom::per_site ? "per-site" : "shared-stream";
}

std::string to_string(HopperEngine value) {
    return value == HopperEngine::fast ? "fast" : "plain";
}

}  // namespace crossgrain::scene
