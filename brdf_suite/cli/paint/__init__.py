"""Commands on paints: design, judge, export."""
