#include "reports/documents/csv.hpp"

#include <vector>

#include "native/base/printable.hpp"
#include "reports/documents/json_text.hpp"

namespace crossgrain::reports {

std::string csv_field(const std::string& given) {
    std::string text = printable_lines(given, std::string::npos);
    if (text.find_first_of("=+-@\t") == 0) text.insert(0, "'");
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

namespace {

/// Fields are numbers, or texts that went through csv_field.
void append_row(std::string& csv, const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) csv += ',';
        csv += fields[i];
    }
    csv += '\n';
}

std::string text_field(const nlohmann::json& object, const char* key) {
    return csv_field(text_at(object, key));
}

std::string element(const nlohmann::json& list, std::size_t i) {
    return i < list.size() && list[i].is_number() ? list[i].dump() : std::string{};
}

std::string settings(const nlohmann::json& object) {
    std::string result;
    const auto found = object.find("settings");
    if (found == object.end() || !found->is_object()) return result;
    for (const auto& [key, value] : found->items()) {
        if (!result.empty()) result += "; ";
        result += key + '=' + (value.is_string() ? value.get<std::string>() : json_text(value, -1));
    }
    return result;
}

}  // namespace

std::string measurements_csv(const nlohmann::json& document) {
    std::string csv;
    append_row(csv, {"case", "code", "variant", "observable", "value", "stderr", "systematic",
                     "ci95_low", "ci95_high", "n", "unit", "settings"});
    for (const auto& item : list_at(document, "cases"))
        for (const auto& m : list_at(item, "measurements")) {
            const auto& ci = list_at(m, "ci95");
            append_row(csv,
                       {text_field(item, "case"), text_field(m, "code"), text_field(m, "variant"),
                        text_field(m, "observable"), number_at(m, "value"), number_at(m, "stderr"),
                        number_at(m, "systematic"), element(ci, 0), element(ci, 1),
                        number_at(m, "n"), text_field(m, "unit"), csv_field(settings(m))});
        }
    return csv;
}

std::string verdicts_csv(const nlohmann::json& document) {
    std::string csv;
    append_row(csv, {"case", "code", "against", "observable", "kind", "setting", "difference",
                     "uncertainty", "limit", "verdict", "expected", "reason", "limit_reason"});
    for (const auto& item : list_at(document, "cases"))
        for (const auto& v : list_at(item, "verdicts")) {
            const auto expected = v.find("expected");
            append_row(csv, {text_field(item, "case"), text_field(v, "code"),
                             text_field(v, "against"), text_field(v, "observable"),
                             text_field(v, "kind"), text_field(v, "setting"),
                             number_at(v, "difference"), number_at(v, "uncertainty"),
                             number_at(v, "limit"), text_field(v, "verdict"),
                             expected != v.end() && expected->is_boolean() ? expected->dump() : "",
                             text_field(v, "reason"), text_field(v, "limit_reason")});
        }
    return csv;
}

}  // namespace crossgrain::reports
