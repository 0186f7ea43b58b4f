// A reference to a callable object, to be passed to functions that are not templates. It consists of two pointers and
// owns nothing; the callable must live until the call to which it is passed returns.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

namespace relief {

template <class Signature>
class FunctionRef;

template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
  public:
    template <class Callable>
    requires(!std::same_as<Callable, FunctionRef> && std::is_invocable_r_v<Result, const Callable&, Arguments...>)
        FunctionRef(const Callable& callable)
        : callable_(&callable), call_([](const void* object, Arguments... arguments) -> Result {
              return (*static_cast<const Callable*>(object))(std::forward<Arguments>(arguments)...);
          }) {}

    Result operator()(Arguments... arguments) const { return call_(callable_, std::forward<Arguments>(arguments)...); }

  private:
    const void* callable_;
    Result (*call_)(const void*, Arguments...);
};

}  // namespace relief
