"""Fields that edit values."""
