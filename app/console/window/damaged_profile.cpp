#include "app/console/window/damaged_profile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <utility>

#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

using widgets::Severity;

/// A name beside the file that nothing has: FILE.damaged, else FILE.damaged-2 and so on.
QString freeName(const QString& path) {
  const QString first = path + QStringLiteral(".damaged");
  QString name = first;
  for (int i = 2; QFileInfo::exists(name) || QFileInfo(name).isSymLink(); ++i) {
    name = first + QStringLiteral("-%1").arg(i);
  }
  return name;
}

}  // namespace

DamagedProfile::DamagedProfile(const PageContext& context, QString profile_path, QObject* parent)
    : QObject(parent),
      context_(context),
      path_(std::move(profile_path)),
      strip_(new widgets::GuideStrip(tr("Saved profile"))) {
  strip_->hide();
  connect(strip_, &widgets::GuideStrip::closeAsked, strip_, &QWidget::hide);
}

void DamagedProfile::tell(const Message& why) {
  strip_->setGuide({}, 0,
                   tr("The saved profile cannot be read, so the devices are not opened. %1. Mend the file and start "
                      "again, or set it aside and go on with the standard values.")
                       .arg(widgets::coreText(why)),
                   {{QStringLiteral("profile_set_aside"), tr("Set it aside"), [this] { setAside(); }}});
  strip_->show();
}

void DamagedProfile::setAside() {
  const QString kept = freeName(path_);
  QFile file(path_);
  if (!file.rename(kept)) {
    context_.tell(Severity::error, tr("The profile could not be set aside as %1: %2.")
                                       .arg(QDir::toNativeSeparators(kept), file.errorString()));
    return;
  }
  context_.tuning.profileSetAside();
  strip_->hide();
  context_.tell(Severity::information, tr("The damaged profile is kept as %1. The standard values are in force.")
                                           .arg(QDir::toNativeSeparators(kept)));
  context_.connection.change(context_.connection.present());
}

}  // namespace fyd::console
