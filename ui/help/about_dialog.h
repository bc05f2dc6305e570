#pragma once
#include <QDialog>

class QPlainTextEdit;
class QStackedWidget;

namespace blossom::ui {

/// What this is, which versions it runs with (to be copied into a report), and the licence.
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
