#pragma once
#include <QDialog>

class QPlainTextEdit;
class QStackedWidget;

namespace blossom::ui {

/// Name, versions of the libraries (which can be copied into a report) and licence.
class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(QWidget* parent = nullptr);

  void copyVersions() const;
  void showLicence(bool shown);
  [[nodiscard]] QString licenceText() const;

 private:
  QWidget* buildHead();
  QWidget* buildVersions();
  QString versions_;
  QStackedWidget* body_;
  QPlainTextEdit* licence_;
};

}  // namespace blossom::ui
