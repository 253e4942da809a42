"""Views and plots of the assistant."""
