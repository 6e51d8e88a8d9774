#include "cases/measure/options.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace crossgrain::measure {
namespace {

template <class T>
std::vector<double> numbers(const T* one) {
    return {static_cast<double>(*one)};
}
std::vector<double> numbers(const std::optional<double>* one) {
    return *one ? std::vector{**one} : std::vector<double>{};
}
template <class T>
std::vector<double> numbers(const std::vector<T>* list) {
    return {list->begin(), list->end()};
}
std::vector<double> numbers(const WordOption& /*word*/) {
    return {};
}

template <class T>
void set(T* one, const std::vector<double>& given) {
    *one = static_cast<T>(given.front());
}
template <class T>
void set(std::vector<T>* list, const std::vector<double>& given) {
    list->clear();
    for (const double number : given)
        list->push_back(static_cast<T>(number));
}
void set(const WordOption& /*word*/, const std::vector<double>& /*given*/) {}

}  // namespace

std::vector<double> numbers_of(const OptionMember& member) {
    return std::visit([](const auto& of) { return numbers(of); }, member);
}

void set_numbers(const OptionMember& member, const std::vector<double>& given) {
    std::visit([&](const auto& of) { set(of, given); }, member);
}

bool is_whole(const OptionMember& member) {
    return std::holds_alternative<int*>(member) || std::holds_alternative<std::int64_t*>(member) ||
           std::holds_alternative<std::vector<std::int64_t>*>(member);
}

bool is_list(const OptionMember& member) {
    return std::holds_alternative<std::vector<double>*>(member) ||
           std::holds_alternative<std::vector<std::int64_t>*>(member);
}

void check_ranges(const OptionKeys& keys) {
    for (const OptionKey& key : keys) {
        for (const double number : numbers_of(key.member)) {
            if (key.range.holds(number)) continue;
            throw std::invalid_argument(fmt::format("'{}' is out of range: {:g}, expected {}",
                                                    key.name, number, key.range.text));
        }
    }
}

OptionKeys joined(OptionKeys first, const OptionKeys& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

}  // namespace crossgrain::measure
