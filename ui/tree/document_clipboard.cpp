#include "ui/tree/document_clipboard.h"

#include <QByteArray>
#include <QMimeData>

#include "core/error.h"
#include "document/edits.h"
#include "document/storage.h"

namespace blossom::ui {

namespace {

const QString featuresType = QStringLiteral("application/x-blossom-features");
constexpr const char* clipKey = "clipboard";

QByteArray written(const ClippedFeatures& clip) {
  Value assets = Value::object();
  for (const auto& [hash, content] : clip.document.assets())
    assets[hash] = QByteArray::fromStdString(*content).toBase64().toStdString();
  return QByteArray::fromStdString(
      toJson(clip.document.withExtra({{clipKey, {{"wanted", clip.wanted}, {"assets", std::move(assets)}}}})));
}

ClippedFeatures read(const QByteArray& bytes) {
  Document document = fromJson(bytes.toStdString()).document;
  const Value extra = document.extra().value(clipKey, Value::object());
  ClippedFeatures clip{document.withExtra(Value::object()), {}};
  if (!extra.is_object() || !extra.value("wanted", Value()).is_array() || !extra.value("assets", Value()).is_object())
    throw Error(ErrorCode::FormatDamaged, "The features of the clipboard are damaged.", "Copy them again.");
  for (const Value& id : extra.at("wanted"))
    if (id.is_string() && document.contains(id.get<std::string>())) clip.wanted.push_back(id.get<std::string>());
  for (const auto& [hash, content] : extra.at("assets").items()) {
    if (!content.is_string()) continue;
    const QByteArray decoded = QByteArray::fromBase64(QByteArray::fromStdString(content.get<std::string>()));
    if (contentHash(decoded.toStdString()) == hash)
      clip.document = clip.document.withAsset(hash, std::make_shared<const std::string>(decoded.toStdString()));
  }
  return clip;
}

// Within the program the document itself is handed on.
class FeatureMimeData final : public QMimeData {
 public:
  explicit FeatureMimeData(ClippedFeatures clip) : clip_(std::move(clip)) {}
  [[nodiscard]] const ClippedFeatures& clip() const { return clip_; }
  [[nodiscard]] QStringList formats() const override { return {featuresType, QStringLiteral("text/plain")}; }
  [[nodiscard]] bool hasFormat(const QString& type) const override { return formats().contains(type); }

 protected:
  [[nodiscard]] QVariant retrieveData(const QString& type, QMetaType) const override {
    if (type == featuresType) return written(clip_);
    if (type == QLatin1String("text/plain")) return QString::fromStdString(toJson(clip_.document));
    return {};
  }

 private:
  ClippedFeatures clip_;
};

}  // namespace

QMimeData* toMimeData(ClippedFeatures clip) {
  clip.document = excerpt(clip.document, clip.wanted);
  return new FeatureMimeData(std::move(clip));
}

std::optional<ClippedFeatures> fromMimeData(const QMimeData* data) {
  if (const auto* own = dynamic_cast<const FeatureMimeData*>(data)) return own->clip();
  if (!holdsFeatures(data)) return std::nullopt;
  return read(data->data(featuresType));
}

bool holdsFeatures(const QMimeData* data) { return data && data->hasFormat(featuresType); }

}  // namespace blossom::ui
