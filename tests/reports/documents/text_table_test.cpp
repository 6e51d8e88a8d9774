// Protects the tables of the terminal: columns align by characters, cells cannot move the cursor.
#include "reports/documents/text_table.hpp"

#include <boost/test/unit_test.hpp>

using crossgrain::reports::TextTable;

BOOST_AUTO_TEST_CASE(columns_align_by_characters_not_bytes) {
    TextTable table({"name", "value"});
    table.add({"gr\xC3\xB6\xC3\x9F"
               "er",
               "1"});
    table.add({"larger", "2"});
    BOOST_TEST(table.text(0) == "name    value\ngr\xC3\xB6\xC3\x9F"
                                "er  1\nlarger  2\n");
}

BOOST_AUTO_TEST_CASE(cells_cannot_move_the_cursor) {
    TextTable table({"name", "value"});
    table.add({"a\nb\x1b[2J\xff", "1"});
    BOOST_TEST(table.text(0) == "name             value\na\\nb\\x1b[2J\\xff  1\n");
}
