#pragma once
#include "document/storage.h"
#include "window_fixture.h"

namespace blossom::ui {

/// The real window and files with documents of one feature, "a", that are told apart by its name.
class DocumentsFixture : public WindowFixture {
 protected:
  static Document part(const std::string& name) {
    Feature feature;
    feature.id = "a";
    feature.type = "test.part";
    feature.name = name;
    return Document().with(std::move(feature));
  }

  QString saved(const QString& name, const Document& document = part("Saved")) {
    const QString file = folder_.filePath(name);
    saveDocument(document, file.toStdString());
    return file;
  }

  void openAll(const QStringList& files) {
    window_->openFiles(files);
    QTRY_VERIFY(!window_->session().job().running() && !window_->session().document().features().empty());
  }
};

}  // namespace blossom::ui
