// A haptic scene: bodies, haptic point, proxy and force, swords, balls and rackets; turned, moved and zoomed with the
// mouse and the keyboard. Drawn in software by a thread of low priority (scene_worker.h); says how many pictures a
// second it shows and of how many triangles.
//
// Left button or arrow keys turn, with Shift or the middle or right button they move, wheel or + and − zoom, Home, 1, 2
// and 3 are the standard views. Where the mouse may drive the haptic point: drag the point, or anywhere with Ctrl or
// while "Touch" is pressed; it moves in the picture's plane through itself, with the wheel or Shift across it. Ctrl and
// arrow keys, Page up and Page down do the same.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <deque>
#include <optional>

#include "widgets/scene/scene_worker.h"

namespace fyd::widgets {

class SceneView : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kTick_ms = 16;
  static constexpr int kStill_ms = 250;  ///< after this time without motion the edges are smoothed

  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Copies the bodies; the data they refer to may be freed. Bad triangles are left out and counted (words()).
  void setBodies(std::span<const SceneBody> bodies);
  /// The same, made ready on another thread.
  void setMeshes(std::shared_ptr<const SceneMeshes> meshes);
  /// A soft body's vertices now, as many as it was given with; other counts are ignored.
  void setShape(std::size_t body, std::span<const Vec3> vertices_mm);
  /// May be called at any rate: the newest is drawn.
  void setState(const SceneState& state);
  /// Words in place of a scene: what to do to get one.
  void setEmptyText(const QString& text);
  /// Lets the mouse and the keyboard drive the haptic point. @param reach where it may be led; empty: anywhere
  void setDrivable(bool on, const SceneBox& reach = {});
  [[nodiscard]] bool drivable() const { return drivable_; }
  /// While it is pressed, a drag anywhere drives the haptic point. Hidden where nothing can be driven.
  [[nodiscard]] QToolButton* touchButton() const { return touch_; }
  void look(SceneSide side);

  [[nodiscard]] const SceneState& state() const { return state_; }
  [[nodiscard]] const SceneCamera& camera() const { return camera_; }
  /// The picture that is shown; null before the first.
  [[nodiscard]] const ScenePicture* picture() const { return answer_ ? &answer_->picture : nullptr; }
  /// The picture's content as text, for screen readers; also shown in place of a picture while there is none.
  [[nodiscard]] QString words() const;
  /// "100,352 triangles · 60 pictures/s".
  [[nodiscard]] QString footText() const { return foot_; }
  /// Shown in the last second while something moves; 0 otherwise.
  [[nodiscard]] double picturesPerSecond() const;
  /// Smooth edges, and nothing left to draw.
  [[nodiscard]] bool settled() const;
  [[nodiscard]] QSize sizeHint() const override { return {480, 360}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 200}; }

 signals:
  void pointDriven(fyd::Vec3 point_mm);  ///< target of the haptic point; always finite
  void pointReleased();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;

 private:
  enum class Hand { nothing, turns, moves, drives };

  void buildButtons();
  void wake();
  [[nodiscard]] bool moving() const;
  void tick();
  void ask(bool finest);
  [[nodiscard]] SceneShot shot() const;
  [[nodiscard]] bool outdated() const;
  [[nodiscard]] SceneBox box() const;
  [[nodiscard]] bool nothingToShow() const;
  void refreshFoot();
  [[nodiscard]] QString hint() const;
  void cameraMoved();  ///< by the operator
  void beginDriving();
  void drive(Vec3 by_mm);
  void release();
  [[nodiscard]] bool onPoint(QPointF at_px) const;
  bool keyed(QKeyEvent* event, bool only_ask);

  SceneWorker worker_;
  std::shared_ptr<const SceneMeshes> meshes_;
  std::vector<SceneShape> shapes_;
  SceneState state_;
  SceneCamera camera_;
  std::unique_ptr<SceneAnswer> answer_;
  std::optional<SceneSide> side_ = SceneSide::home;  ///< until the operator turns or moves it
  bool box_known_ = false;                           ///< a state has come since the bodies: the view fits both
  struct Asked {
    std::shared_ptr<const SceneMeshes> meshes;
    SceneShot shot;
    std::uint64_t number;
  };
  std::optional<Asked> asked_;
  bool parts_asked_ = false;  ///< for the parts and shapes as they are now
  bool finest_asked_ = false;
  bool news_ = false;  ///< to be painted
  QTimer ticks_;
  QElapsedTimer since_change_;
  QElapsedTimer clock_;
  std::deque<qint64> painted_ms_;
  qint64 foot_ms_ = 0;
  QString foot_;
  QString empty_text_;
  QList<QToolButton*> buttons_;
  QToolButton* touch_ = nullptr;

  bool drivable_ = false;
  SceneBox reach_;
  bool hint_ = true;  ///< show how to turn it, until the operator has turned it
  Hand hand_ = Hand::nothing;
  QPointF hand_px_;
  std::optional<Vec3> driven_mm_;
};

}  // namespace fyd::widgets
