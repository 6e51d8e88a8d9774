#include "cases/scene/prepared_state.hpp"

#include "native/base/bounded_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace crossgrain::scene {
namespace {

/// One place for each grain.
std::vector<double> positions(const nlohmann::json& state, const char* axis, std::size_t grains) {
    const auto found = state.find(axis);
    if (found == state.end() || !found->is_array() || found->size() != grains) {
        throw std::invalid_argument(
            fmt::format("'{}' are not the places of {} grains", axis, grains));
    }
    std::vector<double> values;
    values.reserve(grains);
    for (const auto& value : *found) {
        if (!value.is_number() || !std::isfinite(value.get<double>())) {
            throw std::invalid_argument(fmt::format("'{}' holds what is no finite number", axis));
        }
        values.push_back(value.get<double>());
    }
    return values;
}

}  // namespace

InitialState state_from(std::string_view text, std::size_t grains) {
    const nlohmann::json json = bounded_json(text);
    if (!json.is_object()) throw std::invalid_argument("no JSON object");
    InitialState state;
    state.x = positions(json, "x", grains);
    state.y = positions(json, "y", grains);
    return state;
}

std::string text_of(const InitialState& state, double rms_speed) {
    // A number of nlohmann::json reads back to the same bits.
    return nlohmann::json{{"rms_speed", rms_speed}, {"x", state.x}, {"y", state.y}}.dump() + '\n';
}

}  // namespace crossgrain::scene
