#include "cases/observables/option_reading.hpp"

#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::observables {
namespace {

using catalog::ObservableRequest;
using measure::OptionKey;
using measure::OptionKeys;

/// An option at its place in a file.
struct Given {
    const std::string& file;
    const std::string& name;
    const catalog::Option& option;

    [[nodiscard]] CaseError error(std::string problem, std::string got, std::string expected,
                                  std::string hint = {}) const {
        return CaseError({.file = file,
                          .line = option.line,
                          .column = option.column,
                          .key = "observable." + name,
                          .problem = std::move(problem),
                          .got = std::move(got),
                          .expected = std::move(expected),
                          .hint = std::move(hint)});
    }
};

CaseError unknown(const Given& given, const std::string& observable, const OptionKeys& keys) {
    std::vector<std::string> names;
    for (const OptionKey& key : keys)
        names.emplace_back(key.name);
    const auto near = toml_input::nearest(given.name, names);
    return given.error(fmt::format("is not an option of '{}'", observable), "",
                       names.empty() ? "no option"
                                     : fmt::format("one of {}", fmt::join(names, ", ")),
                       near ? fmt::format("did you mean '{}'?", *near) : "");
}

void read_word(const Given& given, const measure::WordOption& option) {
    const std::string& word = given.option.text;
    const auto found = std::ranges::find(option.words, word);
    if (given.option.numbers.empty() && found != option.words.end())
        return option.set(static_cast<std::size_t>(found - option.words.begin()));
    const auto near = toml_input::nearest(word, option.words);
    throw given.error("is not known",
                      given.option.numbers.empty() ? fmt::format("\"{}\"", word) : "a number",
                      fmt::format("one of \"{}\"", fmt::join(option.words, "\", \"")),
                      near ? fmt::format("did you mean \"{}\"?", *near) : "");
}

void read_numbers(const Given& given, const OptionKey& key) {
    const auto& numbers = given.option.numbers;
    if (numbers.empty()) {
        throw given.error("has the wrong type", fmt::format("\"{}\"", given.option.text),
                          key.range.text);
    }
    if (numbers.size() > 1 && !measure::is_list(key.member)) {
        throw given.error("has the wrong type", fmt::format("{} numbers", numbers.size()),
                          key.range.text);
    }
    for (const double number : numbers) {
        const bool is_of_type = !measure::is_whole(key.member) || number == std::round(number);
        if (is_of_type && key.range.holds(number)) continue;
        throw given.error(is_of_type ? "is out of range" : "has the wrong type",
                          fmt::format("{:g}", number), key.range.text);
    }
    measure::set_numbers(key.member, numbers);
}

std::string default_of(const OptionKey& key) {
    if (const auto* word = std::get_if<measure::WordOption>(&key.member))
        return fmt::format("default \"{}\"", word->words[word->standard]);
    const auto numbers = measure::numbers_of(key.member);
    return numbers.empty() ? "" : fmt::format("default {:g}", fmt::join(numbers, ", "));
}

toml_input::Rule rule_of(const OptionKey& key) {
    if (const auto* word = std::get_if<measure::WordOption>(&key.member))
        return toml_input::ChoiceRule{word->words};
    if (measure::is_list(key.member)) return toml_input::NumbersRule{key.range};
    if (!measure::is_whole(key.member)) return toml_input::NumberRule{key.range};
    return toml_input::IntegerRule{static_cast<std::int64_t>(key.range.low),
                                   static_cast<std::int64_t>(key.range.high)};
}

}  // namespace

void read_options(const std::string& file, const ObservableRequest& request,
                  const OptionKeys& keys) {
    for (const auto& [name, option] : request.options) {
        const Given given{file, name, option};
        const auto key = std::ranges::find(keys, name, &OptionKey::name);
        if (key == keys.end()) throw unknown(given, request.name, keys);
        if (const auto* word = std::get_if<measure::WordOption>(&key->member)) {
            read_word(given, *word);
        } else {
            read_numbers(given, *key);
        }
    }
}

std::vector<toml_input::Key> table_keys(const OptionKeys& keys) {
    std::vector<toml_input::Key> result;
    for (const OptionKey& key : keys) {
        const auto numbers = measure::numbers_of(key.member);
        const bool has_default =
            std::ranges::all_of(numbers, [&](double number) { return key.range.holds(number); });
        const std::string standard = has_default ? default_of(key) : "";
        result.emplace_back(std::string(key.name), rule_of(key),
                            fmt::format("{}{}{}", key.text, standard.empty() ? "" : "; ", standard),
                            has_default ? toml_input::Need::optional : toml_input::Need::required);
    }
    return result;
}

}  // namespace crossgrain::observables
