#include "ui/preferences.h"

#include <QSettings>

#include "core/error.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

ParameterSpec declared(std::string name, ParameterSpec spec, const Value& fallback, const QString& help) {
  spec.name = std::move(name);
  spec.help = help.toStdString();
  spec.fallback = checked(spec, fallback);
  return spec;
}

const ParameterSpec& specOf(const std::string& name) {
  for (const PreferenceGroup& group : preferenceGroups())
    for (const ParameterSpec& spec : group.specs)
      if (spec.name == name) return spec;
  throw Error(ErrorCode::NotFound, "There is no preference \"" + name + "\".");
}

QString keyOf(const std::string& name) { return QStringLiteral("preferences/") + qt(name); }

}  // namespace

const std::vector<PreferenceGroup>& preferenceGroups() {
  using P = Preferences;
  static const std::vector<PreferenceGroup> groups{
      {P::tr("Look"),
       {declared("theme", choice({"system", "dark", "light"}), "system",
                 P::tr("Colours of the window; system follows the desktop.")),
        declared("language", choice({"system", "english", "deutsch", "한국어"}), "system",
                 P::tr("Language of the window, from the next start on."))}},
      {P::tr("Units"),
       {declared("length-unit", choice({"mm", "cm", "m", "in"}), "mm",
                 P::tr("In which lengths are shown; any unit may be typed.")),
        declared("decimals", count(0, 8), 3, P::tr("Digits after the point where lengths are shown."))}},
      {P::tr("View"),
       {declared("navigation", choice({"blossom", "freecad", "rhino", "fusion"}), "blossom",
                 P::tr("Which mouse buttons turn, shift and zoom the view.")),
        declared("chord", positiveLength(), 0.05,
                 P::tr("Largest distance between a shape and the polygons that are drawn and exported.")),
        declared("projection", choice({"perspective", "parallel"}), "perspective",
                 P::tr("Of a document when it is opened."))}},
      {P::tr("Work"),
       {declared("autosave", flag(), true, P::tr("Keep a copy of unsaved changes that is offered after a crash.")),
        declared("autosave-minutes", number(0.1, 60), 1.0, P::tr("Time between two such copies, in minutes.")),
        declared("threads", count(0, 256), 0, P::tr("Processor cores to compute with; 0 takes all of them."))}},
  };
  return groups;
}

Preferences& Preferences::instance() {
  static Preferences preferences;
  return preferences;
}

Value Preferences::value(const std::string& name) const {
  const ParameterSpec& spec = specOf(name);
  const QVariant stored = QSettings().value(keyOf(name));
  if (!stored.isValid()) return spec.fallback;
  try {
    return parseText(spec, stored.toString().toStdString());
  } catch (const Error&) {
    return spec.fallback;  // written by another version, or by hand
  }
}

void Preferences::set(const std::string& name, const Value& value) {
  const ParameterSpec& spec = specOf(name);
  const Value wanted = checked(spec, value);
  if (wanted == this->value(name)) return;
  QSettings().setValue(keyOf(name), qt(formatText(spec, wanted)));
  emit changed(qt(name));
}

void Preferences::reset() {
  for (const PreferenceGroup& group : preferenceGroups())
    for (const ParameterSpec& spec : group.specs) set(spec.name, spec.fallback);
}

}  // namespace blossom::ui
