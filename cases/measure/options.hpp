// What [[observable]] may say for an estimator. Beside its options stands a function
//
//   inline OptionKeys option_keys(FlowDepthOptions& o) {
//       return {{"share", &o.share, Range::open(0, 1), "of the bonds lost per period"}, ...};
//   }
//
// and the estimator names its options as `Options`. Reading (cases/observables), the JSON schema
// and the estimator's own check of ranges go by this declaration.
#pragma once

#include "native/base/enum_words.hpp"
#include "native/base/range.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace crossgrain::measure {

/// An option that is one word of an enum.
struct WordOption {
    template <HasWords E>
    explicit WordOption(E& member)
        : words(all_words<E>()), standard(static_cast<std::size_t>(member)),
          set([&member](std::size_t word) { member = static_cast<E>(word); }) {}

    std::vector<std::string> words;
    std::size_t standard;  ///< index of the default
    std::function<void(std::size_t)> set;
};

/// One number, one that may be left out, a list of at least one, the same of whole numbers, a word.
using OptionMember = std::variant<double*, std::optional<double>*, std::vector<double>*, int*,
                                  std::int64_t*, std::vector<std::int64_t>*, WordOption>;

/// An option and the member that it sets; what the member holds is the default.
struct OptionKey {
    std::string_view name;
    OptionMember member;
    Range range;            ///< of every number; whole numbers must have one
    std::string_view text;  ///< meaning and unit, in one line
};
using OptionKeys = std::vector<OptionKey>;

/// The numbers that a member holds now: none, one or several. Nothing for a word.
[[nodiscard]] std::vector<double> numbers_of(const OptionMember& member);
/// Sets a member that is no word to one number, a list to all; whole numbers must be whole.
void set_numbers(const OptionMember& member, const std::vector<double>& given);
[[nodiscard]] bool is_whole(const OptionMember& member);
[[nodiscard]] bool is_list(const OptionMember& member);

/// Throws std::invalid_argument, with the name and the range, for a number out of its range.
void check_ranges(const OptionKeys& keys);

template <class Options>
void check_ranges(Options options) {
    check_ranges(option_keys(options));
}

/// Keys of options within options, and further ones behind them.
[[nodiscard]] OptionKeys joined(OptionKeys first, const OptionKeys& second);

}  // namespace crossgrain::measure
