// A start with a saved profile that cannot be read: the window opens without devices and says why. The file is the
// user's: it is set aside only when asked, and until then nothing is opened with it and nothing saved over it.
#pragma once

#include <QObject>

#include "app/console/shell/page.h"
#include "widgets/status/guide_strip.h"

namespace fyd::console {

class DamagedProfile : public QObject {
  Q_OBJECT
 public:
  DamagedProfile(const PageContext& context, QString profile_path, QObject* parent = nullptr);
  [[nodiscard]] widgets::GuideStrip* strip() const { return strip_; }
  /// @param why the profile cannot be read
  void tell(const Message& why);

 private:
  void setAside();

  PageContext context_;
  QString path_;
  widgets::GuideStrip* strip_ = nullptr;
};

}  // namespace fyd::console
