#include "native/base/bounded_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>

namespace crossgrain {
namespace {

using nlohmann::json;

/// Looks at a document without building it, and stops where it is nested too deep or damaged.
class DepthCheck final : public nlohmann::json_sax<json> {
  public:
    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t /*value*/) override { return true; }
    bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool key(string_t& /*name*/) override { return true; }
    bool start_object(std::size_t /*size*/) override { return deeper(); }
    bool start_array(std::size_t /*size*/) override { return deeper(); }
    bool end_object() override { return higher(); }
    bool end_array() override { return higher(); }
    bool parse_error(std::size_t position, const std::string& /*last*/,
                     const json::exception& /*error*/) override {
        fault_ = fmt::format("is damaged at byte {}", position);
        return false;
    }
    [[nodiscard]] const std::string& fault() const noexcept { return fault_; }

  private:
    bool deeper() {
        if (++depth_ <= deepest_json) return true;
        fault_ = fmt::format("is nested deeper than {} levels", deepest_json);
        return false;
    }
    bool higher() {
        --depth_;
        return true;
    }
    std::size_t depth_ = 0;
    std::string fault_;
};

template <class Input>
void check(const Input& input, json::input_format_t format) {
    DepthCheck depth;
    if (!json::sax_parse(input.begin(), input.end(), &depth, format))
        throw std::invalid_argument(depth.fault());
}

}  // namespace

json bounded_json(std::string_view text) {
    check(text, json::input_format_t::json);
    return json::parse(text);
}

json bounded_cbor(std::span<const std::uint8_t> bytes) {
    check(bytes, json::input_format_t::cbor);
    return json::from_cbor(bytes.begin(), bytes.end());
}

}  // namespace crossgrain
