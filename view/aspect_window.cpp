#include "view/aspect_window.h"

#include <X11/Xlib.h>
#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include "view/vtk_errors.h"

namespace lrcs {
namespace {

// What keys and mouse do.
class AspectStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static AspectStyle* New() {
    auto* style = new AspectStyle;
    style->InitializeObjectBase();
    return style;
  }

  struct Work {
    AspectView* view = nullptr;
    std::function<void()> draw;    // the paper anew, and all of it, quickly
    std::function<void()> smooth;  // all of it once more, with smooth edges
    std::function<void()> save;
    std::function<void(const std::string&)> say;
  };
  Work work;

  void OnLeftButtonDown() override {
    pressed_ = position();
    if (on_target(pressed_)) {
      turning_ = true;
      vtkInteractorStyleTrackballCamera::OnLeftButtonDown();
      return;
    }
    if (const auto part = work.view->sheet().part_at(pressed_)) {
      tell(work.view->pick_part(part));
      work.draw();
      return;
    }
    scrubbing_ = true;
    scrub();
  }

  void OnLeftButtonUp() override {
    constexpr double still = 4.0;  // [pixel]
    const Point at = position();
    scrubbing_ = false;
    if (!turning_) return;
    turning_ = false;
    vtkInteractorStyleTrackballCamera::OnLeftButtonUp();
    if (std::abs(at.x - pressed_.x) + std::abs(at.y - pressed_.y) > still) return;
    tell(work.view->pick_facet(work.view->scene().facet_at(at.x, at.y)));
    work.draw();
  }

  void OnMouseMove() override {
    if (scrubbing_)
      scrub();
    else
      vtkInteractorStyleTrackballCamera::OnMouseMove();
  }

  void OnMouseWheelForward() override {
    if (on_target(position())) vtkInteractorStyleTrackballCamera::OnMouseWheelForward();
  }
  void OnMouseWheelBackward() override {
    if (on_target(position())) vtkInteractorStyleTrackballCamera::OnMouseWheelBackward();
  }

  void OnChar() override {}  // VTK's own keys

  void OnKeyPress() override {
    const std::string key = Interactor->GetKeySym() == nullptr ? "" : Interactor->GetKeySym();
    const long last = last_row(), row = wanted_;
    if (key == "Left") return go_to(row - 1);
    if (key == "Right") return go_to(row + 1);
    if (key == "Prior") return go_to(row - 10);
    if (key == "Next") return go_to(row + 10);
    if (key == "Home") return go_to(0);
    if (key == "End") return go_to(last);
    if (key == "space") return play();
    if (key == "q" || key == "Escape") return Interactor->ExitCallback();
    if (key == "s") return work.save();
    if (key == "l") {
      along_ = !along_;
      work.view->look_from_receiver(along_);
      return work.draw();
    }
    show(key);
  }

  // Rows that were passed over while one was drawn are not drawn: X hands out timers when no key or mouse waits.
  void take_timer(int timer) {
    if (timer == play_timer_) {
      wanted_ = wanted_ < last_row() ? wanted_ + 1 : 0;
      return show_wanted();
    }
    if (timer != go_timer_) return work.smooth();
    go_timer_ = 0;
    show_wanted();
  }

  void OnTimer() override {}  // does not tell which

  void begin() { wanted_ = static_cast<long>(work.view->row()); }

 private:
  [[nodiscard]] Point position() const {
    const int* at = Interactor->GetEventPosition();
    return {at[0] + 0.5, at[1] + 0.5};
  }
  [[nodiscard]] bool on_target(const Point& p) const {
    const Box box = work.view->sheet().target();
    return p.x >= box.low.x && p.x < box.high.x && p.y >= box.low.y && p.y < box.high.y;
  }
  void tell(const std::vector<std::string>& lines) const {
    for (const std::string& line : lines) work.say(line);
  }
  [[nodiscard]] long last_row() const { return static_cast<long>(work.view->rows()) - 1; }
  void go_to(long row) {
    wanted_ = std::clamp(row, 0L, last_row());
    if (go_timer_ == 0) go_timer_ = Interactor->CreateOneShotTimer(1);
  }
  void show_wanted() {
    if (wanted_ == static_cast<long>(work.view->row())) return;
    work.view->go_to(static_cast<std::size_t>(wanted_));
    work.draw();
  }
  void scrub() {
    if (const auto row = work.view->sheet().row_at(position())) go_to(static_cast<long>(*row));
  }
  void play() {
    constexpr unsigned long between = 50;  // [ms]
    if (play_timer_ != 0) Interactor->DestroyTimer(play_timer_);
    play_timer_ = play_timer_ != 0 ? 0 : Interactor->CreateRepeatingTimer(between);
  }
  void show(const std::string& key) {
    FacetShowing showing = work.view->showing();
    constexpr int quantities = 5;
    if (key == "c")
      showing.quantity = static_cast<FacetQuantity>((static_cast<int>(showing.quantity) + 1) % quantities);
    else if (key == "d")
      showing.in_decibels = !showing.in_decibels;
    else if (key == "a")
      showing.per_area = !showing.per_area;
    else if (key == "f")
      showing.darkest = showing.darkest <= -60.0 ? -20.0 : showing.darkest - 20.0;
    else
      return;
    work.view->show(showing);
    work.draw();
  }

  Point pressed_;
  bool turning_ = false, scrubbing_ = false, along_ = false;
  long wanted_ = 0;  // row to be shown next
  int play_timer_ = 0, go_timer_ = 0;
};

// VTK ends the process where it finds no display.
void require_display() {
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0')
    throw std::runtime_error("no window can be opened: DISPLAY is not set; --png FILE draws without one");
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr)
    throw std::runtime_error(
        fmt::format("no window can be opened: DISPLAY={} cannot be reached; --png FILE draws without one", name));
  int first_event = 0, first_error = 0, code = 0;
  const bool has_gl = XQueryExtension(display, "GLX", &code, &first_event, &first_error) != 0;
  XCloseDisplay(display);
  if (!has_gl)
    throw std::runtime_error(
        fmt::format("no window can be opened: DISPLAY={} has no OpenGL; --png FILE draws without", name));
}

// X has one such function a process, and gives it nothing of ours.
void (*when_display_ends)() = nullptr;
int display_has_ended(Display* /*display*/) {
  when_display_ends();
  return 0;
}

class AspectWindow {
 public:
  AspectWindow(AspectView& view, const std::string& title, std::filesystem::path pictures,
               std::function<void(const std::string&)> say)
      : view_(view), pictures_(std::move(pictures)), say_(std::move(say)) {
    paper_mapper_->SetColorWindow(255.0);
    paper_mapper_->SetColorLevel(127.5);
    paper_actor_->SetMapper(paper_mapper_);
    ground_->SetBackground(1.0, 1.0, 1.0);
    ground_->AddViewProp(paper_actor_);
    ground_->InteractiveOff();
    window_->SetNumberOfLayers(3);
    window_->AddRenderer(ground_);
    view_.scene().renderer()->SetLayer(1);
    window_->AddRenderer(view_.scene().renderer());
    window_->AddRenderer(view_.scene().axes());
    window_->SetSize(1600, 900);
    window_->SetWindowName(title.c_str());
    interactor_->SetRenderWindow(window_);
    style_->work = {&view_, [this] { draw(); }, [this] { smooth(); }, [this] { save(); }, say_};
    style_->SetDefaultRenderer(view_.scene().renderer());
    interactor_->SetInteractorStyle(style_);
    interactor_->AddObserver(vtkCommand::ConfigureEvent, this, &AspectWindow::fit);
    timers_->SetClientData(style_.Get());
    timers_->SetCallback([](vtkObject*, unsigned long, void* style, void* timer) {
      static_cast<AspectStyle*>(style)->take_timer(*static_cast<int*>(timer));
    });
    interactor_->AddObserver(vtkCommand::TimerEvent, timers_);
  }

  ~AspectWindow() {
    window_->RemoveRenderer(view_.scene().renderer());
    window_->RemoveRenderer(view_.scene().axes());
  }
  AspectWindow(const AspectWindow&) = delete;
  AspectWindow& operator=(const AspectWindow&) = delete;

  void run() {
    style_->begin();
    fit();
    interactor_->Initialize();
    smooth();
    interactor_->Start();
  }

 private:
  void fit() {
    const int* size = window_->GetSize();
    const int width = std::max(640, size[0]), height = std::max(360, size[1]);
    if (width == width_ && height == height_) return;
    width_ = width, height_ = height;
    view_.resize(width, height);
    const Box box = view_.sheet().target();
    const auto set = [&](vtkRenderer* renderer, double right, double top) {
      renderer->SetViewport(box.low.x / width_, box.low.y / height_, right / width_, top / height_);
    };
    set(view_.scene().renderer(), box.high.x, box.high.y);
    const double side = TargetScene::axes_share * (box.high.x - box.low.x);
    set(view_.scene().axes(), box.low.x + side, box.low.y + side);
    draw();
  }

  void draw() {
    picture_ = view_.paper(aspect_window_keys);
    paper_ = image_on(picture_.rgb.data(), picture_.width, picture_.height, 3);
    paper_mapper_->SetInputData(paper_);
    window_->SetMultiSamples(0);
    window_->Render();
    constexpr unsigned long rest = 150;  // [ms]
    if (timer_ != 0) interactor_->DestroyTimer(timer_);
    if (interactor_->GetInitialized() != 0) timer_ = interactor_->CreateOneShotTimer(rest);
  }

  // Many samples a pixel take a graphics driver in software long.
  void smooth() {
    window_->SetMultiSamples(4);
    window_->Render();
  }

  void save() {
    const int* size = window_->GetSize();
    vtkNew<vtkUnsignedCharArray> rgb;
    smooth();
    window_->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, rgb.Get());
    const auto file = pictures_ / fmt::format("view-{}.png", view_.row());
    try {
      write_png(file, {size[0], size[1], {rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues()}});
      say_(fmt::format("saved {}", file.string()));
    } catch (const std::exception& failed) {
      say_(failed.what());
    }
  }

  AspectView& view_;
  std::filesystem::path pictures_;
  std::function<void(const std::string&)> say_;
  vtkNew<vtkRenderer> ground_;
  vtkNew<vtkImageMapper> paper_mapper_;
  vtkNew<vtkActor2D> paper_actor_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<AspectStyle> style_;
  vtkNew<vtkCallbackCommand> timers_;
  Picture picture_;
  vtkSmartPointer<vtkImageData> paper_;
  int width_ = 0, height_ = 0, timer_ = 0;
};

}  // namespace

void show_aspect_window(AspectView& view, const std::string& title, const std::filesystem::path& pictures,
                        const std::function<void(const std::string&)>& say, void (*display_ends)()) {
  require_display();
  when_display_ends = display_ends;
  XSetIOErrorHandler(display_has_ended);
  AspectWindow(view, title, pictures, say).run();
}

}  // namespace lrcs
