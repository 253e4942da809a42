"""Real-time renderer: prefiltered lobe maps shaded with OpenGL 3.3 core. Plain arrays in, image out.

Import from the modules: ``context`` (windowless contexts), ``values`` (what is drawn), ``renderer``,
``camera`` (pure functions), ``stock_materials``, ``tone_curves``. No fit, no file and no Qt is known here.
"""
