#include "ui/look/registry_text.h"

#include <QCoreApplication>
#include <utility>

#include "document/edits.h"
#include "feature/feature_type.h"

namespace blossom::ui {

QString registryText(const std::string& english) {
  return english.empty() ? QString() : QCoreApplication::translate("Registry", english.c_str());
}

Feature namedFeature(const Document& document, const FeatureType& type, std::vector<FeatureId> inputs) {
  Feature feature = newFeature(document, type, std::move(inputs));
  feature.name = freeName(document, registryText(type.title).toStdString());
  return feature;
}

}  // namespace blossom::ui
