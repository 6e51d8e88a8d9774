#include "app/option_rules.hpp"

#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <system_error>

namespace crossgrain::app {
namespace {

/// The number that the whole text is.
template <class Number>
std::optional<Number> parsed(const std::string& text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

/// An empty text means that the value is accepted.
template <class Accepts>
CLI::Validator rule(std::string expected, Accepts accepts) {
    return {[expected, accepts](std::string& text) {
                return accepts(text)
                           ? std::string()
                           : fmt::format("got '{}', expected {}", printable(text, 60), expected);
            },
            ""};
}

}  // namespace

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
    return rule(fmt::format("a whole number from {} to {}", least, most), [=](const auto& text) {
        const auto value = parsed<std::uint64_t>(text);
        return value && *value >= least && *value <= most;
    });
}

CLI::Validator positive_number(double most) {
    return rule(fmt::format("a number > 0, at most {:g}", most), [=](const auto& text) {
        const auto value = parsed<double>(text);
        return value && *value > 0 && *value <= most;
    });
}

CLI::Validator printable_text(toml_input::TextKind kind) {
    return {[kind](std::string& text) -> std::string {
                const auto fault = toml_input::fault_in(text, kind);
                if (!fault) return {};
                return fmt::format("{}: got {}, expected {}", fault->problem, fault->got,
                                   fault->expected);
            },
            ""};
}

}  // namespace crossgrain::app
