// Words are read as they are written, and a table that does not fit its enum is recognised.
#include "native/base/enum_words.hpp"

#include <boost/test/unit_test.hpp>

#include <optional>
#include <stdexcept>

using namespace crossgrain;

namespace house {

enum class Colour { red, light_blue };
constexpr auto words(Colour /*of*/) {
    return std::array{"red", "light-blue"};
}
enum class Shape { round };

}  // namespace house

using house::Colour;

BOOST_AUTO_TEST_CASE(every_value_is_read_as_it_is_written) {
    for (const auto colour : {Colour::red, Colour::light_blue})
        BOOST_TEST((from_word<Colour>(to_string(colour)) == colour));
    BOOST_TEST(to_string(Colour::light_blue) == "light-blue");
    BOOST_TEST((all_words<Colour>() == std::vector<std::string>{"red", "light-blue"}));
}

BOOST_AUTO_TEST_CASE(another_word_is_no_value) {
    for (const char* word : {"", "Red", "light_blue", "red "})
        BOOST_TEST((from_word<Colour>(word) == std::nullopt));
    BOOST_CHECK_THROW((void)to_string(static_cast<Colour>(2)), std::out_of_range);
}

// What table_of_words asserts of a table that is too short or too long.
static_assert(is_enumerator<Colour::light_blue>());
static_assert(!is_enumerator<static_cast<Colour>(2)>());
static_assert(!is_enumerator<static_cast<Colour>(-1)>());
static_assert(HasWords<Colour>);
static_assert(!HasWords<house::Shape>);
