#include "cases/scene/collision_notation.hpp"

#include <fmt/format.h>

#include <bit>
#include <cctype>
#include <charconv>
#include <optional>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    while (true) {
        const auto begin = text.find_first_not_of(' ');
        if (begin == std::string_view::npos) return words;
        text.remove_prefix(begin);
        const auto length = std::min(text.find(' '), text.size());
        words.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
}

/// The offset k of i, i+k or i-k.
std::optional<int> offset_of(std::string_view word) {
    if (word == "i") return 0;
    if (word.size() != 3 || word[0] != 'i' || word[2] < '1' || word[2] > '5') return std::nullopt;
    if (word[1] != '+' && word[1] != '-') return std::nullopt;
    return word[1] == '+' ? word[2] - '0' : '0' - word[2];
}

/// Recursive descent, brackets not too deep, over: sum = term {(+|-) term}, term = factor {(*|/)
/// factor}, factor = number | p | (sum).
class LinearParser {
  public:
    explicit LinearParser(std::string_view text) : text_(text) {}

    RuleProbability all() {
        const RuleProbability value = sum();
        if (next() != '\0') fail();
        return value;
    }

  private:
    RuleProbability sum() {
        RuleProbability value = term();
        while (next() == '+' || next() == '-') {
            const double sign = text_[at_++] == '+' ? 1 : -1;
            const RuleProbability other = term();
            value.constant += sign * other.constant;
            value.p_factor += sign * other.p_factor;
        }
        return value;
    }
    RuleProbability term() {
        RuleProbability value = factor();
        while (next() == '*' || next() == '/') {
            const bool product = text_[at_++] == '*';
            const RuleProbability other = factor();
            if (product && value.p_factor == 0) {
                value = {value.constant * other.constant, value.constant * other.p_factor};
            } else if (other.p_factor != 0 || (!product && other.constant == 0)) {
                fail();
            } else if (product) {
                value = {value.constant * other.constant, value.p_factor * other.constant};
            } else {
                value = {value.constant / other.constant, value.p_factor / other.constant};
            }
        }
        return value;
    }
    RuleProbability factor() {
        const char first = next();
        if (first == 'p') {
            ++at_;
            return {0, 1};
        }
        if (first == '(') {
            ++at_;
            if (++depth_ > deepest) throw std::invalid_argument("brackets nested too deeply");
            const RuleProbability value = sum();
            if (next() != ')') fail();
            ++at_;
            --depth_;
            return value;
        }
        double value = 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc() || first == '-') fail();
        at_ += static_cast<std::size_t>(end - begin);
        return {value, 0};
    }
    char next() {
        while (at_ < text_.size() && text_[at_] == ' ')
            ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    [[noreturn]] void fail() const { throw std::invalid_argument(fmt::format("\"{}\"", text_)); }

    static constexpr int deepest = 32;

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

SiteText parse_site(std::string_view text) {
    SiteText site;
    bool has_numbers = false;
    for (const std::string_view word : words_of(text)) {
        if (word == "R") {
            ++site.rests;
        } else if (word.size() == 1 && word[0] >= '0' && word[0] <= '5') {
            has_numbers = true;
            site.directions.push_back(word[0] - '0');
        } else if (const auto offset = offset_of(word)) {
            site.is_class = true;
            site.directions.push_back(*offset);
        } else {
            throw std::invalid_argument(fmt::format("\"{}\" in \"{}\"", word, text));
        }
    }
    if (has_numbers && site.is_class) {
        throw std::invalid_argument(fmt::format("numbers and i together in \"{}\"", text));
    }
    return site;
}

SiteState site_of(const SiteText& text, int i, bool mirrored) {
    SiteState site{.rests = static_cast<std::uint8_t>(text.rests)};
    for (const int direction : text.directions) {
        const int offset = mirrored ? -direction : direction;
        const int index = text.is_class ? (i + offset + 12) % 6 : direction;
        if ((site.movers >> index & 1U) != 0) {
            throw std::invalid_argument(fmt::format("direction {} twice", index));
        }
        site.movers = static_cast<std::uint8_t>(site.movers | 1U << index);
    }
    return site;
}

RuleProbability parse_probability(std::string_view text) {
    return LinearParser(text).all();
}

int mass(const SiteState& site) noexcept {
    return std::popcount(site.movers) + site.rests;
}

std::array<int, 2> momentum(const SiteState& site) noexcept {
    constexpr std::array<std::array<int, 2>, 6> velocity{
        {{0, 2}, {1, 1}, {1, -1}, {0, -2}, {-1, -1}, {-1, 1}}};
    std::array<int, 2> sum{0, 0};
    for (std::size_t i = 0; i < 6; ++i) {
        if ((site.movers >> i & 1U) == 0) continue;
        sum[0] += velocity[i][0];
        sum[1] += velocity[i][1];
    }
    return sum;
}

std::string to_string(const SiteState& site) {
    std::string text;
    for (int i = 0; i < 6; ++i) {
        if ((site.movers >> i & 1U) != 0) text += fmt::format("{}{}", text.empty() ? "" : " ", i);
    }
    for (int r = 0; r < site.rests; ++r) {
        text += text.empty() ? "R" : " R";
    }
    return text;
}

}  // namespace crossgrain::scene
