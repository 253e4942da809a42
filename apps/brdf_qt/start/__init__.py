"""The first start: the page with gallery and recent work, and the tour of the window."""
