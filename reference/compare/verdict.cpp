#include "reference/compare/verdict.hpp"

namespace crossgrain::compare {

std::string to_string(const Against& against) {
    switch (against.kind) {
    case Against::Kind::variant:
        return "variant " + against.name;
    case Against::Kind::own_observable:
        return "its own " + against.name;
    case Against::Kind::code:
    case Against::Kind::closed_form:
    case Against::Kind::published:
    case Against::Kind::trend:
        break;
    }
    return against.name;
}

std::string observable_text(const Verdict& verdict) {
    const std::string name =
        verdict.observable + (verdict.column.empty() ? "" : "." + verdict.column);
    switch (verdict.aspect) {
    case Aspect::value:
        break;
    case Aspect::limit:
        return name + " (dt -> 0)";
    case Aspect::order:
        return name + " (order in dt)";
    case Aspect::constant:
        return name + " (constant along " + verdict.along + ")";
    case Aspect::increasing:
        return name + " (increasing along " + verdict.along + ")";
    case Aspect::decreasing:
        return name + " (decreasing along " + verdict.along + ")";
    }
    return name;
}

std::string setting_text(const Verdict& verdict) {
    const bool both = !verdict.variant.empty() && !verdict.place.empty();
    return verdict.variant + (both ? ", " : "") + verdict.place;
}

}  // namespace crossgrain::compare
