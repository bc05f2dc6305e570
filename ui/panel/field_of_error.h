#pragma once
#include <QString>
#include <vector>

namespace blossom::ui {

class ParameterField;

/// The field of the parameter that the message of an error begins with or speaks of; nullptr when it names none.
ParameterField* fieldOfError(const std::vector<ParameterField*>&, const QString& message);

}  // namespace blossom::ui
