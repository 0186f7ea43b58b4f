// Records what a tracer does, for `relief diagnose` and for the window of Reliefscope (Ctrl+T). C++11, no other files.
//
//     relief_recorder::Recorder recorder("hits.csv", "steps.csv", width, height);
//     for (const relief_recorder::Ray& ray : relief_recorder::readRays("rays.csv")) {
//         recorder.ray(ray);
//         ... in the loop:  recorder.step(from, to, height_at_to);
//         ... at the end:   recorder.hit(lambda);    // or miss(), or limit()
//     }
//     recorder.close();  // throws if the files are not complete, as on a full disk
//
// lambda is the descent of the ray: 0 in the polygon's plane (height 1), 1 at the bottom of the relief (height 0). The
// ray is at s = s0 + lambda a, t = t0 + lambda b, texels; texel (i, j) has its centre at (i + 1/2, j + 1/2).
#ifndef RELIEF_RECORDER_H
#define RELIEF_RECORDER_H

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace relief_recorder {

struct Ray {
    double s0, t0, a, b;
};

// Reads the rays that `relief export rays` has written. Throws std::runtime_error.
inline std::vector<Ray> readRays(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "r");
    if (file == nullptr) throw std::runtime_error(path + ": cannot be read");
    std::vector<Ray> rays;
    Ray ray;
    int got = std::fscanf(file, "s0,t0,a,b");
    while ((got = std::fscanf(file, "%lf,%lf,%lf,%lf", &ray.s0, &ray.t0, &ray.a, &ray.b)) == 4) rays.push_back(ray);
    std::fclose(file);
    if (got != EOF || rays.empty()) throw std::runtime_error(path + ": is not a file of rays");
    return rays;
}

// Writes hits, and steps if a file is named for them. width, height: of the height map, texels. own: names of further
// columns of the steps; the window shows them. Throws std::runtime_error if a file cannot be written.
class Recorder {
  public:
    Recorder(const std::string& hits, const std::string& steps, int width, int height,
             const std::vector<std::string>& own = std::vector<std::string>())
        : hits_(hits, true), steps_(steps, !steps.empty()), width_(width), height_(height), own_(own.size()) {
        std::fputs("outcome,lambda,s,t,steps\n", hits_.get());
        if (!steps_.isOpen()) return;
        std::fputs("ray,number,phase,level,i,j,k,lambda_in,lambda_out,z_in,z_out,value,decision,lambda_after,kind",
                   steps_.get());
        for (const std::string& name : own) std::fprintf(steps_.get(), ",%s", name.c_str());
        std::fputs("\n", steps_.get());
    }
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // Ends the files, after the last ray. Throws std::runtime_error if one of them could not be written whole. The
    // destructor ends them, too, but cannot report that.
    void close() {
        hits_.close();
        steps_.close();
    }

    // Begins a ray.
    void ray(const Ray& ray) {
        ray_ = ray;
        ++number_;
        count_ = 0;
        at_ = value_ = 0;
    }
    // The search has looked at the surface at lambda = to, found the height there, and moved on to it from `from`.
    void step(double from, double to, double height, const std::vector<double>& own = std::vector<double>()) {
        write("search", "advance", from, to, height, to, own);
        at_ = to;
        value_ = height;
    }
    // The answer: lambda of the hit; or that there is none; or that the largest number of steps was reached.
    void hit(double lambda) {
        write("refine", "hit", std::fmin(at_, lambda), lambda, value_, lambda, std::vector<double>());
        std::fprintf(hits_.get(), "hit,%.9g,%.9g,%.9g,%ld\n", lambda, ray_.s0 + lambda * ray_.a,
                     ray_.t0 + lambda * ray_.b, count_);
    }
    void miss() { none("miss"); }
    void limit() { none("limit"); }

  private:
    // A file to write, if it is wanted.
    class File {
      public:
        File(const std::string& path, bool isWanted)
            : path_(path), file_(isWanted ? std::fopen(path.c_str(), "w") : nullptr) {
            if (isWanted && !file_) fail();
        }
        bool isOpen() const { return file_ != nullptr; }
        std::FILE* get() const { return file_.get(); }
        void close() {
            if (!file_) return;
            const bool failed = std::ferror(file_.get()) != 0;
            // What the buffer still holds is written here.
            if (std::fclose(file_.release()) != 0 || failed) fail();
        }

      private:
        struct Closer {
            void operator()(std::FILE* file) const { std::fclose(file); }
        };
        void fail() const { throw std::runtime_error(path_ + ": cannot be written"); }

        std::string path_;
        std::unique_ptr<std::FILE, Closer> file_;
    };
    static int wrapped(double at, int size) {
        const double rest = std::fmod(std::floor(at), size);
        return static_cast<int>(rest < 0 ? rest + size : rest);
    }
    void none(const char* outcome) {
        write("search", outcome, at_, at_, value_, at_, std::vector<double>());
        std::fprintf(hits_.get(), "%s,,,,%ld\n", outcome, count_);
    }
    void write(const char* phase, const char* decision, double from, double to, double height, double after,
               const std::vector<double>& own) {
        ++count_;
        if (!steps_.isOpen()) return;
        std::fprintf(steps_.get(), "%ld,%ld,%s,0,%d,%d,0,%.9g,%.9g,%.9g,%.9g,%.9g,%s,%.9g,point", number_, count_,
                     phase, wrapped(ray_.s0 + to * ray_.a, width_), wrapped(ray_.t0 + to * ray_.b, height_), from, to,
                     1 - from, 1 - to, height, decision, after);
        for (std::size_t n = 0; n < own_; ++n) {
            std::fputs(",", steps_.get());
            if (n < own.size()) std::fprintf(steps_.get(), "%.9g", own[n]);
        }
        std::fputs("\n", steps_.get());
    }

    File hits_, steps_;
    int width_, height_;
    std::size_t own_;
    Ray ray_ = Ray();
    long number_ = -1, count_ = 0;
    double at_ = 0, value_ = 0;
};

}  // namespace relief_recorder

#endif
