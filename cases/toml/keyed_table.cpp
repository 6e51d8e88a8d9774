#include "cases/toml/keyed_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace crossgrain::toml_input {
namespace {

const Key* find_in(const std::vector<Key>& keys, std::string_view name) {
    const auto found = std::ranges::find(keys, name, &Key::name);
    return found == keys.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> Kinds::words() const {
    std::vector<std::string> words;
    for (const auto& [word, keys] : of)
        words.push_back(word);
    return words;
}

const Key* KeyedTable::find(std::string_view key) const {
    if (const Key* own = find_in(keys_->keys, key)) return own;
    if (keys_->kinds && table_.is_text(keys_->kinds->key)) {
        const std::string word = table_.text(keys_->kinds->key);
        for (const auto& [kind, keys] : keys_->kinds->of) {
            if (kind == word) return find_in(keys().keys, key);
        }
    }
    return keys_->others ? &*keys_->others : nullptr;
}

const Key& KeyedTable::declared(std::string_view key) const {
    if (const Key* found = find(key)) return *found;
    throw std::logic_error(fmt::format("'{}' is read and not declared", table_.dotted(key)));
}

template <class R>
const R& KeyedTable::rule(std::string_view key) const {
    for (const Rule& form : declared(key).rules)
        if (const auto* found = std::get_if<R>(&form)) return *found;
    throw std::logic_error(fmt::format("'{}' is declared as something else", table_.dotted(key)));
}

bool KeyedTable::has(std::string_view key) const {
    (void)declared(key);
    return table_.has(key);
}

double KeyedTable::number(std::string_view key) const {
    return table_.number(key, rule<NumberRule>(key).range);
}

std::optional<double> KeyedTable::optional_number(std::string_view key) const {
    return table_.optional_number(key, rule<NumberRule>(key).range);
}

std::vector<double> KeyedTable::numbers(std::string_view key) const {
    const auto& allowed = rule<NumbersRule>(key);
    auto values = table_.numbers(key, allowed.range);
    if (values.size() > allowed.most) {
        throw table_.error(key, "has the wrong length", fmt::format("{}", values.size()),
                           fmt::format("at most {} numbers: {}", allowed.most, declared(key).text));
    }
    return values;
}

std::int64_t KeyedTable::integer(std::string_view key) const {
    const auto& allowed = rule<IntegerRule>(key);
    return table_.integer(key, allowed.least, allowed.most);
}

std::string KeyedTable::text(std::string_view key) const {
    const auto& allowed = rule<TextRule>(key);
    auto text = allowed.kind == TextKind::name    ? table_.name(key)
                : allowed.kind == TextKind::prose ? table_.prose(key)
                                                  : table_.text(key);
    if (text.empty() && !allowed.may_be_empty)
        throw table_.error(key, "is empty", "\"\"", declared(key).text);
    return text;
}

std::optional<std::string> KeyedTable::optional_text(std::string_view key) const {
    return has(key) ? std::optional(text(key)) : std::nullopt;
}

std::vector<std::string> KeyedTable::texts(std::string_view key) const {
    const auto& words = rule<TextsRule>(key).words;
    auto texts = table_.texts(key);
    for (const auto& text : texts) {
        if (words.empty() || std::ranges::find(words, text) != words.end()) continue;
        const auto near = nearest(text, words);
        throw table_.error(key, "names what is not known", fmt::format("\"{}\"", text),
                           fmt::format("some of \"{}\"", fmt::join(words, "\", \"")),
                           near ? fmt::format("did you mean \"{}\"?", *near) : "");
    }
    return texts;
}

bool KeyedTable::boolean(std::string_view key) const {
    (void)rule<BooleanRule>(key);
    return table_.boolean(key);
}

std::size_t KeyedTable::choice(std::string_view key) const {
    return table_.choice(key, rule<ChoiceRule>(key).words);
}

std::string KeyedTable::exactly_one(std::string_view key) const {
    const auto group = std::ranges::find_if(keys_->groups, [&](const OneOf& g) {
        return std::ranges::find(g.keys, key) != g.keys.end();
    });
    if (group == keys_->groups.end())
        throw std::logic_error(fmt::format("'{}' is in no group", table_.dotted(key)));
    std::string found;
    for (const auto& one : group->keys) {
        if (!has(one)) continue;
        if (!found.empty()) {
            throw error(one, "contradicts", fmt::format("'{}' as well", table_.dotted(found)),
                        "one of the two", "remove one");
        }
        found = one;
    }
    if (found.empty()) {
        throw missing(group->keys.front(),
                      fmt::format("one of '{}'", fmt::join(group->keys, "', '")));
    }
    return found;
}

bool KeyedTable::is_text(std::string_view key) const {
    (void)declared(key);
    return table_.is_text(key);
}

bool KeyedTable::is_table(std::string_view key) const {
    (void)declared(key);
    return table_.is_table(key);
}

KeyedTable KeyedTable::table(std::string_view key) const {
    const TableKeys& keys = rule<TableRule>(key).keys();
    return {table_.table(key), keys};
}

void KeyedTable::check_table(std::string_view key) const {
    (void)declared(key);
    (void)table_.table(key);
}

std::vector<KeyedTable> KeyedTable::tables(std::string_view key) const {
    const TableKeys& keys = rule<TablesRule>(key).keys();
    std::vector<KeyedTable> result;
    for (TomlTable& entry : table_.tables(key))
        result.emplace_back(std::move(entry), keys);
    return result;
}

CaseError KeyedTable::missing(std::string_view key, std::string expected) const {
    (void)declared(key);
    return table_.missing(key, std::move(expected));
}

CaseError KeyedTable::error(std::string_view key, std::string problem, std::string got,
                            std::string expected, std::string hint) const {
    return table_.error(key, std::move(problem), std::move(got), std::move(expected),
                        std::move(hint));
}

}  // namespace crossgrain::toml_input
