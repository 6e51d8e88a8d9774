// Whether a text is well-formed XML 1.0, as far as JUnit files go: elements with attributes, text
// and character references; no comments, no CDATA, no document type.
#pragma once

#include <nlohmann/json.hpp>

#include <regex>
#include <string>
#include <vector>

namespace crossgrain::tests {

/// What is wrong with the text, or "".
inline std::string fault_in_xml(const std::string& text) {
    try {
        (void)nlohmann::json(text).dump();
    } catch (const nlohmann::json::exception&) {
        return "bytes that are not UTF-8";
    }
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r')
            return "a control character";
    }
    if (text.find("\xEF\xBF\xBE") != std::string::npos ||
        text.find("\xEF\xBF\xBF") != std::string::npos)
        return "a noncharacter";
    static const std::regex reference("&(amp|lt|gt|quot|apos|#[0-9]+);");
    const std::string plain = std::regex_replace(text, reference, "");
    if (plain.find('&') != std::string::npos) return "a bare &";
    static const std::regex tag(R"re(<(/?)([a-z-]+)( [a-z]+="[^"<]*")*(/?)>)re");
    static const std::regex declaration(R"re(^<\?xml [^?]*\?>)re");
    const std::string body = std::regex_replace(plain, declaration, "");
    std::vector<std::string> open;
    std::string between;
    auto last = body.begin();
    for (std::sregex_iterator it(body.begin(), body.end(), tag), end; it != end; ++it) {
        between.append(last, it->operator[](0).first);
        last = it->operator[](0).second;
        const std::string name = it->str(2);
        if (it->length(1) > 0) {
            if (open.empty() || open.back() != name) return "</" + name + "> closes nothing";
            open.pop_back();
        } else if (it->length(4) == 0) {
            open.push_back(name);
        }
    }
    between.append(last, body.end());
    if (between.find('<') != std::string::npos) return "a bare <";
    return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

}  // namespace crossgrain::tests
