#include "cases/scene/choices.hpp"

#include "cases/scene/scene_file.hpp"

namespace crossgrain::scene {

std::vector<std::string> words_of(const std::string& key) {
    for (const auto& declared : scene_keys().keys) {
        if (declared.name != key) continue;
        const auto* choice = std::get_if<toml_input::ChoiceRule>(&declared.rules.front());
        if (choice != nullptr) return choice->words;
    }
    return {};
}

}  // namespace crossgrain::scene
