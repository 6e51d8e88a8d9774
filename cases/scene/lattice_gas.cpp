#include "cases/scene/lattice_gas.hpp"

namespace crossgrain::scene {

std::string to_string(Matching value) {
    return value == Matching::exact ? "exact" : "spectators";
}
std::string to_string(WallPlace value) {
    return value == WallPlace::inside ? "inside" : "outside";
}
std::string to_string(Relocation value) {
    return value == Relocation::origin_first ? "origin-first" : "random-walk";
}
std::string to_string(PipeEnds value) {
    return value == PipeEnds::periodic ? "periodic" : "open";
}
std::string to_string(OnSaturation value) {
    return value == OnSaturation::fail ? "fail" : "record";
}
std::string to_string(GasEngine value) {
    return value == GasEngine::bit_sliced ? "bit-sliced" : "table";
}

}  // namespace crossgrain::scene
