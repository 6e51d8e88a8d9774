#include "reports/documents/junit.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "reports/documents/json_text.hpp"

namespace crossgrain::reports {
namespace {

using Json = nlohmann::json;

enum class Result { passed, failure, error, skipped };

struct TestCase {
    std::string name;
    Result result = Result::error;
    std::string message;  ///< one line: numbers and reason
};

struct Suite {
    std::string name;
    std::vector<TestCase> tests;
};

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
    for (const std::string_view word : words)
        if (text == word) return true;
    return false;
}

bool as_expected(const Json& verdict, std::string_view outcome) {
    const auto found = verdict.find("expected");
    if (found != verdict.end() && found->is_boolean()) return found->get<bool>();
    return is_one_of(outcome, {"agree", "not_installed", "not_expressible"});
}

Result result_of(const Json& verdict) {
    const std::string outcome = text_at(verdict, "verdict");
    if (!is_one_of(outcome, {"agree", "disagree", "undecided", "not_expressible", "not_installed",
                             "no_reference"}))
        return Result::error;  // run_failed, or a word that must not be mistaken for success
    if (!as_expected(verdict, outcome)) return Result::failure;
    return is_one_of(outcome, {"agree", "disagree"}) ? Result::passed : Result::skipped;
}

/// XML 1.0 cannot hold most control characters nor U+FFFE and U+FFFF, and bytes that are not UTF-8
/// make it unreadable.
std::string xml(const std::string& text) {
    std::string clean = Json::parse(json_text(text, -1)).get<std::string>();
    for (const char* noncharacter : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
        for (auto at = clean.find(noncharacter); at != std::string::npos;
             at = clean.find(noncharacter, at))
            clean.replace(at, 3, "?");
    }
    std::string result;
    for (const char c : clean) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\n':
            result += "&#10;";
            break;
        case '\t':
            result += "&#9;";
            break;
        default:
            result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
        }
    }
    return result;
}

std::string numbers_of(const Json& verdict) {
    std::string text = text_at(verdict, "verdict");
    if (text.empty()) text = "no verdict";
    const auto add = [&](const char* key, std::string_view word) {
        const std::string number = number_at(verdict, key);
        if (!number.empty()) text += fmt::format(", {} {}", word, number);
    };
    add("difference", "difference");
    add("uncertainty", "+-");
    add("limit", "limit");
    if (const auto reason = text_at(verdict, "limit_reason"); !reason.empty())
        text += fmt::format(" ({})", reason);
    if (const auto reason = text_at(verdict, "reason"); !reason.empty())
        text += fmt::format(": {}", reason);
    return text;
}

TestCase test_of(const Json& verdict) {
    std::string name =
        fmt::format("{} [{}] {} {}", text_at(verdict, "observable"), text_at(verdict, "kind"),
                    text_at(verdict, "code"), text_at(verdict, "against"));
    if (const auto setting = text_at(verdict, "setting"); !setting.empty())
        name += fmt::format(" ({})", setting);
    return {.name = std::move(name), .result = result_of(verdict), .message = numbers_of(verdict)};
}

TestCase certificate_test_of(const Json& pair) {
    return {.name = fmt::format("{} {} {}", text_at(pair, "case"), text_at(pair, "a"),
                                text_at(pair, "b")),
            .result = result_of(pair),
            .message = numbers_of(pair)};
}

std::vector<Suite> suites_of(const Json& document) {
    std::vector<Suite> suites;
    for (const auto& item : list_at(document, "cases")) {
        Suite suite{.name = text_at(item, "case"), .tests = {}};
        for (const auto& verdict : list_at(item, "verdicts"))
            suite.tests.push_back(test_of(verdict));
        if (!suite.tests.empty()) suites.push_back(std::move(suite));
    }
    if (const auto found = document.find("certificate"); found != document.end()) {
        Suite suite{.name = "certificate", .tests = {}};
        for (const auto& pair : list_at(*found, "pairs"))
            suite.tests.push_back(certificate_test_of(pair));
        if (!suite.tests.empty()) suites.push_back(std::move(suite));
    }
    return suites;
}

std::string xml_of(const TestCase& test, const std::string& suite) {
    const std::string message = xml(test.message);
    const std::string open =
        fmt::format("    <testcase classname=\"{}\" name=\"{}\">", xml(suite), xml(test.name));
    const auto element = [&](std::string_view tag) {
        return fmt::format("{}<{} message=\"{}\"/></testcase>\n", open, tag, message);
    };
    switch (test.result) {
    case Result::passed:
        return fmt::format("{}<system-out>{}</system-out></testcase>\n", open, message);
    case Result::failure:
        return element("failure");
    case Result::skipped:
        return element("skipped");
    case Result::error:
        break;
    }
    return element("error");
}

std::string counts_of(const std::vector<TestCase>& tests) {
    std::size_t failures = 0;
    std::size_t errors = 0;
    std::size_t skipped = 0;
    for (const TestCase& test : tests) {
        failures += test.result == Result::failure;
        errors += test.result == Result::error;
        skipped += test.result == Result::skipped;
    }
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", tests.size(),
                       failures, errors, skipped);
}

}  // namespace

std::string junit_xml(const nlohmann::json& document) {
    std::string body;
    std::vector<TestCase> all;
    for (const Suite& suite : suites_of(document)) {
        body +=
            fmt::format("  <testsuite name=\"{}\" {}>\n", xml(suite.name), counts_of(suite.tests));
        for (const TestCase& test : suite.tests) {
            body += xml_of(test, suite.name);
            all.push_back(test);
        }
        body += "  </testsuite>\n";
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<testsuites name=\"crossgrain\" {}>\n{}</testsuites>\n",
                       counts_of(all), body);
}

}  // namespace crossgrain::reports
