#include "cases/scene/choices.hpp"

#include "cases/scene/scene.hpp"

namespace crossgrain::scene {
namespace {

template <class Choice>
std::vector<std::string> words_up_to(Choice last) {
    std::vector<std::string> words;
    for (int i = 0; i <= static_cast<int>(last); ++i)
        words.push_back(to_string(static_cast<Choice>(i)));
    return words;
}

}  // namespace

std::vector<std::string> words_of(const std::string& key) {
    if (key == "integrator") return words_up_to(Integrator::taguchi_adaptive_euler);
    if (key == "precision") return words_up_to(Precision::mixed);
    if (key == "contacts") return words_up_to(Contacts::lattice_neighbours);
    return {};
}

}  // namespace crossgrain::scene
