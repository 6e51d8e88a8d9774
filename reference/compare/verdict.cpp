#include "reference/compare/verdict.hpp"

namespace crossgrain::compare {

std::string to_string(Kind kind) {
    switch (kind) {
    case Kind::exact:
        return "exact";
    case Kind::parity:
        return "parity";
    case Kind::agree:
        return "agree";
    case Kind::published:
        return "published";
    }
    return {};
}

std::string to_string(Outcome outcome) {
    switch (outcome) {
    case Outcome::agree:
        return "agree";
    case Outcome::disagree:
        return "disagree";
    case Outcome::undecided:
        return "undecided";
    case Outcome::not_expressible:
        return "not_expressible";
    case Outcome::not_installed:
        return "not_installed";
    case Outcome::run_failed:
        return "run_failed";
    case Outcome::no_reference:
        return "no_reference";
    }
    return {};
}

}  // namespace crossgrain::compare
