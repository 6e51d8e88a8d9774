#include "app/settings.hpp"

#include "native/base/printable.hpp"

namespace crossgrain::app {

std::string command_text(const std::vector<std::string>& arguments) {
    constexpr std::size_t longest = 1000;
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "%+,-./:=@_";
    std::string text = "crossgrain";
    for (const std::string& argument : arguments) {
        const std::string word = printable(argument, longest);
        if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
            text += " " + word;
            continue;
        }
        text += " '";
        for (const char c : word)
            text += c == '\'' ? std::string("'\\''") : std::string(1, c);
        text += "'";
    }
    return text;
}

}  // namespace crossgrain::app
