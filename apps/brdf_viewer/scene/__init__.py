"""What is shown: state, loading, drawing."""
