#include "reports/documents/json_text.hpp"

#include <cmath>

namespace crossgrain::reports {

std::string json_text(const nlohmann::json& value, int indent) {
    return value.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

const nlohmann::json& list_at(const nlohmann::json& object, const char* key) {
    static const nlohmann::json none = nlohmann::json::array();
    if (!object.is_object()) return none;
    const auto found = object.find(key);
    return found != object.end() && found->is_array() ? *found : none;
}

std::string text_at(const nlohmann::json& object, const char* key) {
    if (!object.is_object()) return {};
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

std::string number_at(const nlohmann::json& object, const char* key) {
    if (!object.is_object()) return {};
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return {};
    if (found->is_number_float() && !std::isfinite(found->get<double>())) return {};
    return found->dump();
}

}  // namespace crossgrain::reports
