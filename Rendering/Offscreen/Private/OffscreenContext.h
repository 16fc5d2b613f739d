#ifndef OffscreenContext_h
#define OffscreenContext_h

/**
 * An OpenGL context without a surface, owned: destroying the object destroys the context,
 * after having released it where it was current in the calling thread.
 *
 * Knows nothing of VTK. A context may be current in one thread at a time.
 */
class OffscreenContext
{
public:
  using Function = void (*)();

  OffscreenContext() = default;
  virtual ~OffscreenContext() = default;
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// Makes the context current in the calling thread; cheap if it is already. False on failure.
  virtual bool MakeCurrent() = 0;

  virtual bool IsCurrent() const = 0;

  /// MakeCurrent(), remembering what was current for the next PopCurrent(). Pairs nest.
  virtual void PushCurrent() = 0;
  virtual void PopCurrent() = 0;

  /// The address of the OpenGL function of that name, or nullptr.
  virtual Function GetFunction(const char* name) const = 0;

  /// What the context is, for messages: "EGL, surfaceless Mesa platform".
  virtual const char* GetDescription() const = 0;
};

#endif
