#include "ui/panel/field_of_error.h"

#include <algorithm>

#include "ui/fields/parameter_field.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

/// "height must be ..", "x of height must be ..", "item 2 of heights must ..".
bool isAbout(const QString& message, const QString& parameter) {
  for (qsizetype at = message.indexOf(parameter, 0, Qt::CaseInsensitive); at >= 0;
       at = message.indexOf(parameter, at + 1, Qt::CaseInsensitive)) {
    const QString before = message.left(at), after = message.mid(at + parameter.size());
    const bool starts = before.isEmpty() || before == QLatin1String("The ") || before.endsWith(QLatin1String(" of ")) ||
                        before.endsWith(u'"');
    const bool ends = after.isEmpty() || !after.front().isLetterOrNumber();
    if (starts && ends && !before.contains(QLatin1String(" must "))) return true;
  }
  return false;
}

}  // namespace

ParameterField* fieldOfError(const std::vector<ParameterField*>& fields, const QString& message) {
  const auto named = std::find_if(fields.begin(), fields.end(), [&](const ParameterField* field) {
    return isAbout(message, qt(label(field->spec()))) || isAbout(message, qt(field->spec().name));
  });
  return named == fields.end() ? nullptr : *named;
}

}  // namespace blossom::ui
