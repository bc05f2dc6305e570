#pragma once
#include <QObject>
#include <filesystem>
#include <vector>

#include "app/app.h"

class QWidget;

namespace blossom::ui {

class DocumentPage;
struct ExportScope;

/// Writing results of a document into files of other programs: what, in which format, and where.
class DocumentExport : public QObject {
  Q_OBJECT
 public:
  DocumentExport(App, QWidget* window);
  void choose(DocumentPage&);

 private:
  [[nodiscard]] static std::vector<ExportScope> scopesOf(DocumentPage&);
  /// Asks whether files that are there may be replaced.
  [[nodiscard]] bool mayReplace(const std::vector<std::filesystem::path>& there) const;

  App app_;
  QWidget* window_;
};

}  // namespace blossom::ui
