#include "cases/scene/plates_file.hpp"

namespace crossgrain::scene {
namespace {

using toml_input::ChoiceRule;
using toml_input::Key;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::OneOf;
using toml_input::Range;
using toml_input::TableKeys;
using toml_input::TableRule;
using enum toml_input::Need;

/// y = height + amplitude cos(2 pi (t/period + phase))
std::vector<Key> motion_keys() {
    return {{"amplitude", NumberRule{Range::not_negative()}, "of its motion, default 0"},
            {"period", NumberRule{Range::positive()}, "of its motion, needed with an amplitude"},
            {"phase", NumberRule{Range::any()}, "of its motion in periods, default 0"}};
}

const TableKeys& bottom_keys() {
    static const TableKeys keys = [] {
        TableKeys bottom{.name = "plates.bottom", .keys = motion_keys()};
        bottom.keys.emplace_back("height", NumberRule{Range::any()}, "y at rest", required);
        return bottom;
    }();
    return keys;
}

/// Free with a mass, else prescribed like the bottom.
const TableKeys& lid_keys() {
    static const TableKeys keys = [] {
        TableKeys lid{.name = "plates.lid", .keys = motion_keys()};
        lid.keys.emplace_back("mass", NumberRule{Range::positive()}, "of a lid that is free");
        lid.keys.emplace_back("height", NumberRule{Range::any()},
                              "y at the start or at rest; of a free lid default 0");
        lid.keys.emplace_back("velocity", NumberRule{Range::any()},
                              "of a free lid at the start, default 0");
        for (const char* moved : {"amplitude", "period", "phase"}) {
            lid.groups.push_back(OneOf{{"mass", moved}, false});
            lid.groups.push_back(OneOf{{"velocity", moved}, false});
        }
        return lid;
    }();
    return keys;
}

PrescribedPlate read_prescribed_plate(const KeyedTable& t) {
    const PrescribedPlate plate{.height = t.number("height"),
                                .amplitude = t.optional_number("amplitude").value_or(0),
                                .period = t.optional_number("period").value_or(1),
                                .phase = t.optional_number("phase").value_or(0)};
    if (plate.amplitude > 0 && !t.has("period")) {
        throw t.missing("period", "the period of the plate's motion");
    }
    t.reject_unknown_keys();
    return plate;
}

Lid read_lid(const KeyedTable& t) {
    if (!t.has("mass")) return read_prescribed_plate(t);
    const FreeLid lid{.mass = t.number("mass"),
                      .height = t.optional_number("height").value_or(0),
                      .velocity = t.optional_number("velocity").value_or(0)};
    t.reject_unknown_keys();
    return lid;
}

}  // namespace

const TableKeys& plates_keys() {
    static const TableKeys keys{
        .name = "plates",
        .keys = {{"touch", ChoiceRule{all_words<PlateContact>()}, "what of a grain they act on",
                  required},
                 {"stiffness", NumberRule{Range::positive()}, "left out: the contact's"},
                 {"bottom", TableRule{bottom_keys},
                  "y = height + amplitude cos(2 pi (t/period + phase))"},
                 {"lid", TableRule{lid_keys}, "free with a mass, or prescribed like the bottom"}}};
    return keys;
}

Plates read_plates(const KeyedTable& t, double contact_stiffness) {
    Plates plates;
    plates.touches = t.choice<PlateContact>("touch");
    plates.stiffness = t.optional_number("stiffness").value_or(contact_stiffness);
    if (t.has("bottom")) plates.bottom = read_prescribed_plate(t.table("bottom"));
    if (t.has("lid")) plates.lid = read_lid(t.table("lid"));
    t.reject_unknown_keys();
    return plates;
}

}  // namespace crossgrain::scene
