#include "ui/look/units.h"

#include "ui/look/text.h"
#include "ui/settings/preferences.h"

namespace blossom::ui {

const LengthUnit& lengthUnit() {
  static const auto preferred = [] {
    const std::string name = Preferences::instance().get<std::string>("length-unit");
    return LengthUnit{name, millimetresPer(name)};
  };
  static LengthUnit unit = preferred();
  static const auto following =
      QObject::connect(&Preferences::instance(), &Preferences::changed, [](const QString& changed) {
        if (changed == QLatin1String("length-unit")) unit = preferred();
      });
  Q_UNUSED(following)
  return unit;
}

QString readableLength(double millimetres, int digits) {
  const LengthUnit& unit = lengthUnit();
  return readable(millimetres / unit.millimetres, digits) + u' ' + qt(unit.name);
}

}  // namespace blossom::ui
