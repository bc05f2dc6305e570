#include "ui/look/units.h"

#include "ui/look/preferences.h"
#include "ui/look/text.h"

namespace blossom::ui {

const LengthUnit& lengthUnit() {
  static LengthUnit unit;
  static int known = -1;
  // Asked, not told: whoever shows lengths anew may hear of a change before a connection made here would.
  if (const int changes = Preferences::instance().changes(); changes != known) {
    const std::string name = Preferences::instance().get<std::string>("length-unit");
    unit = {name, millimetresPer(name)};
    known = changes;
  }
  return unit;
}

QString readableLength(double millimetres, int digits) {
  const LengthUnit& unit = lengthUnit();
  return readable(millimetres / unit.millimetres, digits) + u' ' + qt(unit.name);
}

}  // namespace blossom::ui
