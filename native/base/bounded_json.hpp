// JSON and CBOR from files that anybody may have written: nested no deeper than we write them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace crossgrain {

/// Deepest nesting of tables and lists that is read. Ours have at most 5 levels; parsers and
/// destructors that call themselves run out of stack at some 10^5.
inline constexpr std::size_t deepest_json = 64;

/// Parse a text, or CBOR. Throw std::invalid_argument with one line for what is damaged or nested
/// too deep.
[[nodiscard]] nlohmann::json bounded_json(std::string_view text);
[[nodiscard]] nlohmann::json bounded_cbor(std::span<const std::uint8_t> bytes);

}  // namespace crossgrain
