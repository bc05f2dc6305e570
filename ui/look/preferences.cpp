#include "ui/look/preferences.h"

#include <QSettings>

#include "core/error.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

// Names are keys of the settings and labels of the form at once; as labels they are translated.
[[maybe_unused]] constexpr const char* shownNames[] = {QT_TRANSLATE_NOOP("Registry", "theme"),
                                                       QT_TRANSLATE_NOOP("Registry", "language"),
                                                       QT_TRANSLATE_NOOP("Registry", "length unit"),
                                                       QT_TRANSLATE_NOOP("Registry", "navigation"),
                                                       QT_TRANSLATE_NOOP("Registry", "drawing tolerance"),
                                                       QT_TRANSLATE_NOOP("Registry", "projection"),
                                                       QT_TRANSLATE_NOOP("Registry", "zebra stripes"),
                                                       QT_TRANSLATE_NOOP("Registry", "zebra angle"),
                                                       QT_TRANSLATE_NOOP("Registry", "iso curves"),
                                                       QT_TRANSLATE_NOOP("Registry", "autosave"),
                                                       QT_TRANSLATE_NOOP("Registry", "autosave minutes"),
                                                       QT_TRANSLATE_NOOP("Registry", "threads"),
                                                       QT_TRANSLATE_NOOP("Registry", "system"),
                                                       QT_TRANSLATE_NOOP("Registry", "dark"),
                                                       QT_TRANSLATE_NOOP("Registry", "light"),
                                                       QT_TRANSLATE_NOOP("Registry", "perspective"),
                                                       QT_TRANSLATE_NOOP("Registry", "parallel")};

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
  static const std::vector<PreferenceGroup> groups{
      {Preferences::tr("Look"),
       {declared("theme", choice({"system", "dark", "light"}), "system",
                 Preferences::tr("Colours of the window; system follows the desktop.")),
        declared("language", choice({"system", "english", "deutsch", "한국어"}), "system",
                 Preferences::tr("Language of the window, from the next start on."))}},
      {Preferences::tr("View"),
       {declared("navigation", choice({"blossom", "freecad", "rhino", "fusion"}), "blossom",
                 Preferences::tr("Which mouse buttons turn, shift and zoom the view.")),
        declared("projection", choice({"perspective", "parallel"}), "perspective",
                 Preferences::tr("Of a document when it is opened.")),
        declared("drawing-tolerance", lengthFromZero(), 0.0,
                 Preferences::tr("How far what is drawn may lie from the shape itself; 0: chosen by its size. Results and "
                                 "files do not depend on it.")),
        declared("zebra-stripes", count(1, 200), 12,
                 Preferences::tr("How many dark stripes the surroundings have that zebra stripes mirror.")),
        declared("zebra-angle", angle(), 0.0, Preferences::tr("How far these stripes are turned from level.")),
        declared("iso-curves", count(0, 100), 8,
                 Preferences::tr("How many curves of constant parameter a face shows in each direction."))}},
      {Preferences::tr("Work"),
       {declared("length-unit", choice({"mm", "cm", "m", "in", "ft"}), "mm",
                 Preferences::tr("In which lengths are shown, and what a number without a unit means. Files stay in mm.")),
        declared("autosave", flag(), true, Preferences::tr("Keep a copy of unsaved changes that is offered after a crash.")),
        declared("autosave-minutes", number(0.1, 60), 1.0, Preferences::tr("Time between two such copies, in minutes.")),
        declared("threads", count(0, 256), 0, Preferences::tr("Processor cores to compute with; 0 takes all of them."))}},
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
  ++changes_;
  emit changed(qt(name));
}

void Preferences::reset() {
  for (const PreferenceGroup& group : preferenceGroups())
    for (const ParameterSpec& spec : group.specs) set(spec.name, spec.fallback);
}

}  // namespace blossom::ui
