#include "app/console/review/session_list.h"

#include <QCompleter>
#include <QDir>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/catalogue/catalogue.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {
namespace {

using Found = Result<std::vector<catalogue::CatalogueEntry>>;

constexpr std::size_t kMostRows = 500;

Found search(const std::string& catalogue, const std::string& text) {
  auto opened = catalogue::Catalogue::open(catalogue);
  if (!opened) return tl::unexpected(opened.error());
  return opened->search({.text = text, .limit = kMostRows});
}

QString howToOpen() {
  return SessionList::tr("Enter or a double click opens a session. Two chosen, the second with Ctrl, can be compared.");
}

QString stateWord(const catalogue::CatalogueEntry& entry) {
  switch (entry.file_state) {
    case catalogue::FileState::missing: return SessionList::tr("file missing");
    case catalogue::FileState::replaced: return SessionList::tr("another file");
    case catalogue::FileState::present: break;
  }
  switch (entry.wholeness) {
    case recording::Wholeness::growing: return SessionList::tr("being recorded");
    case recording::Wholeness::crashed: return SessionList::tr("recorder crashed");
    case recording::Wholeness::damaged: return SessionList::tr("damaged");
    case recording::Wholeness::whole: break;
  }
  if (entry.gaps > 0) return SessionList::tr("%n sample(s) lost", nullptr, static_cast<int>(entry.gaps));
  return entry.health == "gaps" ? SessionList::tr("parts missing") : SessionList::tr("whole");
}

}  // namespace

SessionList::SessionList(QString catalogue, RecentRecordings& recent, QWidget* parent)
    : QWidget(parent),
      catalogue_(std::move(catalogue)),
      filter_(new QLineEdit(this)),
      table_(new QTableWidget(this)),
      path_(new QLineEdit(this)),
      open_(new QPushButton(tr("Open"), this)),
      choose_(new QPushButton(tr("Open a file…"), this)),
      recent_(new QToolButton(this)),
      compare_(new QPushButton(tr("Compare the two"), this)),
      recover_(new QPushButton(tr("Recover"), this)),
      words_(new QLabel(this)) {
  build();
  connect(filter_, &QLineEdit::textChanged, this, [this] {
    problem_.clear();
    look();
  });
  connect(path_, &QLineEdit::returnPressed, this, &SessionList::openPath);
  connect(open_, &QPushButton::clicked, this, &SessionList::openPath);
  connect(recover_, &QPushButton::clicked, this, &SessionList::recoverPath);
  connect(choose_, &QPushButton::clicked, this, &SessionList::chooseFile);
  connect(compare_, &QPushButton::clicked, this, &SessionList::compareChosen);
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { compare_->setEnabled(chosenRows().size() == 2); });
  auto* lately = new QMenu(recent_);
  recent.fill(*lately, [this](const QString& path) { emit openAsked(path); });
  recent_->setMenu(lately);
  connect(table_, &QTableWidget::cellActivated, this, [this](int row, int) {
    emit openAsked(QString::fromStdString(entries_[static_cast<std::size_t>(row)].path));
  });
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) { choose(row); });
}

void SessionList::build() {
  filter_->setObjectName(QStringLiteral("session_filter"));
  filter_->setPlaceholderText(tr("Search operator, subject, notes, tags"));
  filter_->setAccessibleName(filter_->placeholderText());
  filter_->setClearButtonEnabled(true);
  const QStringList columns = {tr("Began, UTC"), tr("Length"), tr("Operator"), tr("Subject"),
                               tr("Tags"),       tr("State"),  tr("Notes")};
  table_->setObjectName(QStringLiteral("session_table"));
  table_->setAccessibleName(tr("Recorded sessions"));
  table_->setColumnCount(static_cast<int>(columns.size()));
  table_->setHorizontalHeaderLabels(columns);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setTabKeyNavigation(false);
  path_->setObjectName(QStringLiteral("session_path"));
  path_->setPlaceholderText(
      tr("Path of a recording, such as %1").arg(QDir::homePath() + QStringLiteral("/session.h5")));
  path_->setAccessibleName(tr("Path of a recording"));
  recover_->setObjectName(QStringLiteral("list_recover_button"));
  recover_->setToolTip(tr("Makes a recording whole whose recorder crashed or that is damaged. Nothing is deleted."));
  choose_->setToolTip(tr("Any recording's file (Ctrl+O); it can be dropped onto the window, too"));
  recent_->setObjectName(QStringLiteral("recent_button"));
  recent_->setText(tr("Opened lately"));
  recent_->setPopupMode(QToolButton::InstantPopup);
  compare_->setToolTip(tr("Choose two sessions, the second with Ctrl: the later one is drawn faint behind the first."));
  compare_->setEnabled(false);
  auto* files = new QFileSystemModel(path_);
  files->setRootPath(QString());
  path_->setCompleter(new QCompleter(files, path_));
  words_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(widgets::kGrid);
  layout->addWidget(filter_);
  layout->addWidget(table_, 1);
  layout->addWidget(words_);
  auto* row = new QHBoxLayout;
  row->addWidget(path_, 1);
  row->addWidget(open_);
  row->addWidget(choose_);
  row->addWidget(recent_);
  row->addWidget(compare_);
  row->addWidget(recover_);
  layout->addLayout(row);
}

void SessionList::look() {
  say(tr("Searching …"));
  work_.run([this, catalogue = catalogue_.toStdString(),
             text = filter_->text().toStdString()](const std::stop_token&) -> Background::Finish {
    auto found = std::make_shared<Found>(guarded([&] { return search(catalogue, text); }));
    return [this, found] {
      fill(*found ? **found : std::vector<catalogue::CatalogueEntry>{});
      if (!*found) say(widgets::coreText(found->error().message));
    };
  });
}

void SessionList::fill(const std::vector<catalogue::CatalogueEntry>& entries) {
  const int chosen_column = table_->currentColumn();
  entries_.clear();
  table_->setRowCount(0);
  entries_ = entries;
  table_->setRowCount(static_cast<int>(entries.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const catalogue::CatalogueEntry& e = entries_[static_cast<std::size_t>(row)];
    QStringList tags;
    for (const std::string& tag : e.tags) tags << QString::fromStdString(tag);
    const QStringList cells = {
        QString::fromStdString(e.started_utc).left(19).replace(QLatin1Char('T'), QLatin1Char(' ')),
        widgets::durationText(e.duration_s),
        QString::fromStdString(e.operator_name),
        QString::fromStdString(e.subject),
        tags.join(QStringLiteral(", ")),
        stateWord(e),
        QString::fromStdString(e.notes).split(QLatin1Char('\n'), Qt::SkipEmptyParts).join(QStringLiteral(" · "))};
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(QString::fromStdString(e.path));
      table_->setItem(row, column, item);
    }
  }
  if (!entries.empty()) {
    say(howToOpen());
  } else if (filter_->text().isEmpty()) {
    say(tr("No session is in the catalogue yet. Record one in Operate (Ctrl+R), or name a recording's file below."));
  } else {
    say(tr("No session has these words."));
  }
  chooseAgain(chosen_column);
}

void SessionList::choose(int row) {
  if (row < 0 || static_cast<std::size_t>(row) >= entries_.size()) return;
  problem_.clear();
  const catalogue::CatalogueEntry& entry = entries_[static_cast<std::size_t>(row)];
  chosen_ = entry;
  path_->setText(QString::fromStdString(entry.path));
  explain(entry);
}

/// Selects the chosen session again, which may be in another row now, or in none. A path typed since is kept.
void SessionList::chooseAgain(int column) {
  const auto found = std::ranges::find(entries_, chosen_.id, &catalogue::CatalogueEntry::id);
  if (found == entries_.end()) return;
  if (path_->text() == QString::fromStdString(chosen_.path)) path_->setText(QString::fromStdString(found->path));
  chosen_ = *found;
  const QSignalBlocker quiet(table_);
  table_->setCurrentCell(static_cast<int>(found - entries_.begin()), std::max(0, column));
  explain(*found);
}

void SessionList::explain(const catalogue::CatalogueEntry& entry) {
  const bool present = entry.file_state == catalogue::FileState::present;
  if (present && entry.wholeness == recording::Wholeness::crashed) {
    say(tr("Its recorder crashed. Recover makes it whole; it can be opened as it is, too."));
  } else if (present && entry.wholeness == recording::Wholeness::damaged) {
    say(tr("It is damaged. Recover keeps what can be proven; it can be opened as it is, too."));
  } else {
    say(howToOpen());
  }
}

void SessionList::say(const QString& text) {
  words_->setText(problem_.isEmpty() ? text : problem_);
  words_->setProperty("role", problem_.isEmpty() ? "" : "warning");
  widgets::restyle(*words_);
}

void SessionList::sayProblem(const QString& text) {
  problem_ = text;
  say(text);
}

void SessionList::chooseFile() {
  askForRecording(this, tr("Recording to open"), QFileInfo(path_->text()).absolutePath(),
                  [this](const QString& path) { emit openAsked(path); });
}

std::vector<int> SessionList::chosenRows() const {
  std::vector<int> rows;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows()) rows.push_back(index.row());
  std::ranges::sort(rows);
  return rows;
}

void SessionList::compareChosen() {
  problem_.clear();
  const std::vector<int> rows = chosenRows();
  if (rows.size() != 2) {
    say(tr("Choose two sessions to compare, the second with Ctrl."));
    return;
  }
  const auto path = [&](int row) { return QString::fromStdString(entries_[static_cast<std::size_t>(row)].path); };
  emit compareAsked(path(rows[1]), path(rows[0]));
}

QString SessionList::namedPath() {
  problem_.clear();
  QString path = path_->text().trimmed();
  if (path.isEmpty()) say(tr("Choose a session, or write the path of a recording."));
  return path;
}

void SessionList::openPath() {
  if (const QString path = namedPath(); !path.isEmpty()) emit openAsked(path);
}

void SessionList::recoverPath() {
  if (const QString path = namedPath(); !path.isEmpty()) emit recoverAsked(path);
}

}  // namespace fyd::console
